// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/common_region.hpp"

namespace plenum {

/// A local minimum of |y - x| in the region, from `start`: steps that project onto the
/// linearised parts, with the step along the surface from its curvature (Barzilai & Borwein 1988,
/// doi 10.1093/imanum/8.1.141) and a trust radius of `reach` [m] at most. May fail: check the
/// result.
template <int Dim>
Vec<Dim> descend(const CommonRegion<Dim>& region, const Vec<Dim>& x, const Vec<Dim>& start,
                 double reach);

}  // namespace plenum
