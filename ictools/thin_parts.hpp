// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"

#include <cmath>
#include <numbers>

namespace plenum {

/// Faces whose outer normals have a smaller product than this are opposite: within 25 degrees of
/// parallel.
inline const double oppositeCosine = -std::cos(25 * std::numbers::pi / 180);

/// Looks for places where a fluid's region is thinner than d_ref between two opposite faces (within
/// 25 degrees of parallel; the tip of a wedge is not thin). Throws InputError if such a part stays
/// empty: no particle within 2 d_ref. Warns, with the place, if it does hold particles.
template <int Dim>
void checkThinParts(const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame,
                    const Warn& warn);

}  // namespace plenum
