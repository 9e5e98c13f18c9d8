// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"
#include "particles/case_settings.hpp"
#include "particles/vec.hpp"

#include <algorithm>
#include <vector>

namespace plenum {

/// A plane across an axis through which fluid comes in or leaves. Depths are distances beyond it,
/// away from the scene.
template <int Dim>
struct StreamPlane {
  int axis = 0;
  double outward = -1;  ///< +1 or -1: the direction away from the scene, along the axis
  double at = 0;        ///< [m]
  double length = 0;    ///< of the held fluid [m]
  bool isInflow = true;

  /// Where the held fluid ends, along the axis [m].
  double end() const { return at + outward * length; }
  double depth(const Vec<Dim>& x) const { return outward * (x[axis] - at); }
  /// The part of a velocity that points into the stream's direction: in at an inflow, out at an
  /// outflow [m/s].
  double along(const Vec<Dim>& v) const { return (isInflow ? -outward : outward) * v[axis]; }
};

/// The planes of a case. Without any, nothing is held, and asking costs nothing to speak of.
template <int Dim>
class StreamPlanes {
 public:
  explicit StreamPlanes(const SolverSettings& settings) {
    for (const StreamSettings& s : settings.inflows) add(s, true);
    for (const StreamSettings& s : settings.outflows) add(s, false);
  }

  auto begin() const { return planes_.begin(); }
  auto end() const { return planes_.end(); }
  bool empty() const { return planes_.empty(); }

  /// The plane beyond which a place lies; null for none.
  const StreamPlane<Dim>* beyond(const Vec<Dim>& x) const {
    for (const StreamPlane<Dim>& plane : planes_)
      if (plane.depth(x) > 0) return &plane;
    return nullptr;
  }

  /// Whether fluid there keeps its smoothing length and density, too: it lies so deep that part of
  /// its neighbourhood may be missing.
  bool isDeep(const Vec<Dim>& x) const {
    for (const StreamPlane<Dim>& plane : planes_)
      if (plane.depth(x) > 0.5 * plane.length) return true;
    return false;
  }

  /// A box that covers what is held beyond the planes, too.
  Box<Dim> covering(Box<Dim> box) const {
    for (const StreamPlane<Dim>& plane : planes_) {
      double &lower = box.lower[plane.axis], &upper = box.upper[plane.axis];
      lower = std::min(lower, plane.end());
      upper = std::max(upper, plane.end());
    }
    return box;
  }

 private:
  void add(const StreamSettings& s, bool isInflow) {
    planes_.push_back({s.axisNumber(), s.isLower() ? -1.0 : 1.0, s.at, s.length, isInflow});
  }

  std::vector<StreamPlane<Dim>> planes_;
};

}  // namespace plenum
