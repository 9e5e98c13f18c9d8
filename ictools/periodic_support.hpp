// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"

namespace plenum {

/// Throws InputError if a periodic axis is shorter than twice the largest support of a fluid's
/// particles, which `matchMasses` may have made larger than that of the scene.
template <int Dim>
void checkSupports(const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame);

}  // namespace plenum
