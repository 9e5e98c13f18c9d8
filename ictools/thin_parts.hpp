// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace plenum {

/// Faces whose outer normals have a smaller product than this are opposite: within 25 degrees of
/// parallel.
inline const double oppositeCosine = -std::cos(25 * std::numbers::pi / 180);

/// A place where a region is thin.
template <int Dim>
struct ThinPlace {
  Vec<Dim> point;        ///< on the surface [m]
  Vec<Dim> normal;       ///< unit normal there, out of the region
  double thickness = 0;  ///< along the normal from side to side [m]
};

/// The place where a fluid's region is thinnest between two opposite faces (as below), looked at
/// about every spacing; none if it is thinner than `widest` [m] nowhere, or is the whole domain.
template <int Dim>
std::optional<ThinPlace<Dim>> thinnestPlace(const FluidFill<Dim>& fluid,
                                            const SceneFrame<Dim>& frame, double widest);

/// Looks for places where a fluid's region is thinner than d_ref between two opposite faces (within
/// 25 degrees of parallel; the tip of a wedge is not thin). Throws FaultyInput, with an error for
/// each fluid, if such a part stays empty: no particle within 2 d_ref. Warns, with the place, if it
/// does hold particles.
template <int Dim>
void checkThinParts(const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame,
                    const Warn& warn);

}  // namespace plenum
