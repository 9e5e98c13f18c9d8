// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"
#include "ictools/wall_layers.hpp"

namespace plenum {

/// How fine the fluid is that a wall bounds.
struct WallResolution {
  double finest = 1, coarsest = 1;  ///< s/d_ref along its surface
  double support = 0;               ///< largest of the kernels that reach behind it [m]
};

/// Looks along the part of the surface of `solid` that has fluid before it.
template <int Dim>
WallResolution resolutionAlong(const WallSolid<Dim>& solid,
                               const std::vector<FluidFill<Dim>>& fluids,
                               const SceneFrame<Dim>& frame);

}  // namespace plenum
