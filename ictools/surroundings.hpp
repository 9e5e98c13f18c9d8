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

/// What stands around the fluids as far as kernels reach: the walls' particles, and where a fluid
/// ends without a wall (a free surface) points as if it went on there, on its lattice or in layers
/// along its surface, so that nothing spreads into the void. `lengthOverSpacing` is h over the edge
/// of a particle's volume. Where spacing follows density, layers and reach are those of the fluid
/// along its surface.
template <int Dim>
std::vector<FixedPoint<Dim>> surroundings(const std::vector<FluidFill<Dim>>& fluids,
                                          const std::vector<WallFill<Dim>>& walls,
                                          const SceneFrame<Dim>& frame, double lengthOverSpacing);

}  // namespace plenum
