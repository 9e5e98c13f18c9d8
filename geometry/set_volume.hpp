// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace plenum {

/// How two regions lie to each other, as far as it can be proven cheaply.
enum class Relation { disjoint, firstInSecond, secondInFirst, unknown };

/// What two boxes have in common; its lower corner is not below the upper one if that is nothing.
template <int Dim>
Box<Dim> commonBox(const Box<Dim>& a, const Box<Dim>& b) {
  Box<Dim> box;
  for (int k = 0; k < Dim; ++k) {
    box.lower[k] = std::max(a.lower[k], b.lower[k]);
    box.upper[k] = std::min(a.upper[k], b.upper[k]);
  }
  return box;
}

/// Volumes of set operations.
template <int Dim>
struct SetVolume {
  using Parts = std::vector<GeometryPtr<Dim>>;
  /// The nearest surface of any part that matters at a point; its signed distance bounds the true
  /// one from below in size and has its sign.
  using Surface = std::function<SurfacePoint<Dim>(const Vec<Dim>&)>;

  static Relation relationOf(const Geometry<Dim>& first, const Geometry<Dim>& second);

  /// Exact where parts are nested, disjoint or boxes; nothing where that cannot be proven.
  static std::optional<Measure> ofUnion(Parts parts);
  static std::optional<Measure> ofIntersection(Parts parts);
  static std::optional<Measure> ofDifference(Parts parts);

  /// By subdivision of `box`; cells that the surface crosses count as cut by its tangent plane. The
  /// error is estimated from the last refinements and never above the proven bound, the volume of
  /// all cells that the surface may cross.
  static Measure bySubdivision(const Surface& surface, const Box<Dim>& box);
};

}  // namespace plenum
