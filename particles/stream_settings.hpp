// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planes through which fluid comes in or leaves: [[solver.inflow]] and [[solver.outflow]].
#pragma once

#include "particles/section.hpp"

#include <string>

namespace plenum {

/// A plane across an axis. Fluid beyond it, away from the scene, is held: it keeps its velocity.
struct StreamSettings {
  std::string axis = "x";
  double at = 0;               ///< of the plane, along the axis [m]
  std::string side = "lower";  ///< of the scene on which the plane lies: "lower" or "upper"
  double length = 0;           ///< from the plane to the end of the held fluid [m]

  int axisNumber() const { return axis[0] - 'x'; }
  bool isLower() const { return side == "lower"; }
};

Section<StreamSettings> inflowSection();
Section<StreamSettings> outflowSection();

}  // namespace plenum
