// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every set operation is the common region C of parts, some of them turned inside out:
//   intersection = common region of all,  difference = first and the outsides of the others,
//   union = outside of the common region of all outsides.
// C is taken as the closure of its interior: where parts only touch there is no surface.
#pragma once

#include "geometry/geometry.hpp"

#include <optional>
#include <vector>

namespace plenum {

/// One region or, with sign -1, its outside.
template <int Dim>
struct Part {
  GeometryPtr<Dim> geometry;
  double sign = 1;

  SurfacePoint<Dim> closest(const Vec<Dim>& x) const {
    SurfacePoint<Dim> hit = geometry->closest(x);
    hit.normal *= sign;
    hit.signedDistance *= sign;
    return hit;
  }
};

template <int Dim>
class CommonRegion {
 public:
  /// `searchBox` is finite and contains some of the region's interior if there is any.
  CommonRegion(std::vector<Part<Dim>> parts, const Box<Dim>& searchBox);

  /// The nearest surface point of the part that is violated most, or that ends nearest.
  SurfacePoint<Dim> bindingPart(const Vec<Dim>& x) const;

  /// max over parts of the signed distance: <= 0 in C, exact inside, a lower bound of the distance
  /// outside. [m]
  double value(const Vec<Dim>& x) const;

  /// The true nearest point of C's surface; the region must not be empty.
  SurfacePoint<Dim> closest(const Vec<Dim>& x) const;

  /// No interior point was found in the search box.
  bool isEmpty() const { return !interior_; }

  /// Lengths below this are taken as zero [m].
  double resolution() const { return resolution_; }
  const std::vector<Part<Dim>>& parts() const { return parts_; }

  /// `p` of value <= resolution has interior of C in every neighbourhood.
  bool touchesInterior(const Vec<Dim>& p) const;

 private:
  std::optional<Vec<Dim>> findInterior(const Box<Dim>& searchBox) const;

  std::vector<Part<Dim>> parts_;
  double resolution_;
  std::optional<Vec<Dim>> interior_;  ///< a point well inside
};

}  // namespace plenum
