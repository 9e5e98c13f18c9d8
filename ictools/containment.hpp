// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"

#include <span>

namespace plenum {

/// A particle's new place, kept within its fluid.
template <int Dim>
struct Kept {
  Vec<Dim> position;     ///< in the domain [m]
  double clearance = 0;  ///< how far it may move from there before it must be asked again [m]
};

/// Where the particles of one fluid may be: inside its region and outside of those of the fluids
/// before it, at least `margin` [m] away from every surface but periodic faces, beyond which the
/// region goes on.
template <int Dim>
class Containment {
 public:
  /// `fluids[k]` is the fluid meant; all of them must outlive this.
  Containment(std::span<const FluidFill<Dim>> fluids, std::size_t k, const Box<Dim>& domain,
              double margin);

  /// kept[i] is points[i], or the nearest place that is allowed; `before` [m], where the particles
  /// came from, where none is found near. All have the same length. From all threads.
  void keep(std::span<const Vec<Dim>> points, std::span<const Vec<Dim>> before,
            std::span<Kept<Dim>> kept) const;

 private:
  Kept<Dim> keep(const Vec<Dim>& point, const Vec<Dim>& before) const;
  SurfacePoint<Dim> nearestSurface(const Vec<Dim>& x) const;
  bool isPeriodicFace(const Vec<Dim>& foot) const;

  std::vector<GeometryPtr<Dim>> inside_;   // one or none
  std::vector<GeometryPtr<Dim>> outside_;  // of earlier fluids
  Box<Dim> domain_;
  double margin_;
};

}  // namespace plenum
