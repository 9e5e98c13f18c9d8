// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/walls.hpp"

namespace plenum {

/// The thinnest place of the solid behind a wall.
template <int Dim>
struct ThroughThickness {
  double thickness = 0;  ///< along the normal from side to side [m]; infinite if nowhere thin
  Vec<Dim> at{};         ///< on the surface [m]
};

/// Looks from the particles next to the surface of wall `w` straight through all solids, as far as
/// its layers reach: where the way ends before, at a surface within 25 degrees of parallel (the tip
/// of a wedge is not thin), no more wall than that lies between one side and the other.
template <int Dim>
ThroughThickness<Dim> throughThickness(const std::vector<WallFill<Dim>>& walls, std::size_t w,
                                       const SceneFrame<Dim>& frame);

/// Puts into `thickness` of every wall what really stands there: the depth of its layers, or less
/// where its solid is thinner. Warns, with place and remedy, if that is less than the kernel's
/// support.
template <int Dim>
void measureThickness(std::vector<WallFill<Dim>>& walls, const SceneFrame<Dim>& frame,
                      const Warn& warn);

}  // namespace plenum
