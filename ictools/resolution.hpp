// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "ictools/ic_settings.hpp"

#include <memory>
#include <span>
#include <vector>

namespace plenum {

/// A place where particles stand closer, and how their spacing grows away from it.
template <int Dim>
struct Refinement {
  RefineSettings settings;
  GeometryPtr<Dim> region;

  /// Distances of points from the refined place [m]; 0 inside of it.
  void distances(std::span<const Vec<Dim>> points, std::span<double> result) const;
};

/// The spacing that is wanted at a place, over that of the scene:
/// s/d_ref = min(1, min over refinements of spacing + growth distance/d_ref).
template <int Dim>
class Resolution {
 public:
  /// `spacing` is d_ref [m].
  Resolution(std::vector<Refinement<Dim>> refinements, double spacing);

  const std::vector<Refinement<Dim>>& refinements() const { return refinements_; }

  /// result[k] = s/d_ref at points[k], in (0, 1]. May be asked from several threads.
  void at(std::span<const Vec<Dim>> points, std::span<double> result) const;

  /// result[k] = a distance from points[k] within which nothing is refined [m]; 0 where it is.
  void plainAround(std::span<const Vec<Dim>> points, std::span<double> result) const;

  double finest() const { return finest_; }    ///< s/d_ref in a refined place
  double steepest() const { return growth_; }  ///< largest |grad s|

 private:
  std::vector<Refinement<Dim>> refinements_;
  double spacing_, finest_ = 1, growth_ = 0;
};

template <int Dim>
using ResolutionPtr = std::shared_ptr<const Resolution<Dim>>;

/// s/d_ref at all points, from all threads.
template <int Dim>
std::vector<double> ratiosAt(const Resolution<Dim>& resolution, std::span<const Vec<Dim>> points);

}  // namespace plenum
