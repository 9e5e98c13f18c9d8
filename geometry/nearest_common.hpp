// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/common_region.hpp"

namespace plenum {

/// Projects `x`, outside of `region`, onto it.
///
/// Cells around x that the Lipschitz bound of the signed distances proves empty or too far are
/// dropped, level by level (branch and bound); from what remains, `descend` runs to the local
/// minima exactly. `interior` is any point inside the region.
template <int Dim>
Vec<Dim> nearestCommonPoint(const CommonRegion<Dim>& region, const Vec<Dim>& x,
                            const Vec<Dim>& interior);

}  // namespace plenum
