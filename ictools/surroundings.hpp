// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/walls.hpp"

namespace plenum {

/// A particle that stays where it is while fluids are arranged against it.
template <int Dim>
struct FixedPoint {
  Vec<Dim> position;  ///< [m]
  double volume = 0;  ///< that it stands for [m^d]
};

/// What stands around the fluids as far as `reach` [m]: the walls' particles, and where a fluid
/// ends without a wall (a free surface) lattice points of spacing `spacing` [m] as if it went on
/// there, so that nothing spreads into the void.
template <int Dim>
std::vector<FixedPoint<Dim>> surroundings(const std::vector<FluidFill<Dim>>& fluids,
                                          const std::vector<WallFill<Dim>>& walls,
                                          const SceneFrame<Dim>& frame, double reach,
                                          double spacing);

}  // namespace plenum
