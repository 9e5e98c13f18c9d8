// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"
#include "particles/scene.hpp"

namespace plenum {

/// Puts the particles of `fluids` where those of `scene`, which was made from the same case, stand,
/// in the order of their ids. Throws InputError if the scene has other fluids or particles outside
/// of their regions.
template <int Dim>
void takePlaces(std::vector<FluidFill<Dim>>& fluids, const Scene<Dim>& scene,
                const SceneFrame<Dim>& frame);

}  // namespace plenum
