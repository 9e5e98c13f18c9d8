// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "ictools/fluids.hpp"
#include "ictools/regions.hpp"
#include "ictools/scene_frame.hpp"
#include "particles/container_map.hpp"

#include <vector>

namespace plenum {

/// Where fluid may be: the region that `container` names, or where fluids start; none for a fluid
/// that fills the whole domain. Throws InputError for a container that is infinite.
template <int Dim>
std::vector<GeometryPtr<Dim>> containerRegions(const CaseNode& root, const CaseSettings& settings,
                                               const Regions<Dim>& regions,
                                               const std::vector<FluidFill<Dim>>& fluids,
                                               const SceneFrame<Dim>& frame);

/// Samples the signed distance to the union of `regions` on a grid of d_ref/2 in steps of d_ref/32,
/// exact in the cells that the surface crosses, elsewhere at most as large as it is,
/// clipped at +-127 steps (just below 4 d_ref), over their bounds (finite on open axes) and a
/// margin of 4 d_ref on open axes. Empty for no regions: fluid may be everywhere.
template <int Dim>
ContainerMap<Dim> containerMap(const std::vector<GeometryPtr<Dim>>& regions,
                               const SceneFrame<Dim>& frame);

}  // namespace plenum
