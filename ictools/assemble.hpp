// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/walls.hpp"
#include "particles/scene.hpp"

namespace plenum {

/// All particles with their state. The fluids hand over their points and keep their number.
template <int Dim>
ParticleSet<Dim> assemble(std::vector<FluidFill<Dim>>& fluids,
                          const std::vector<WallFill<Dim>>& walls, const SceneFrame<Dim>& frame);

/// Named figures of the set: numbers of particles, masses and their deviation from density times
/// volume, spacing used along fitted axes, layers, smallest distance of two particles [d_ref].
template <int Dim>
std::vector<std::pair<std::string, double>> qualityFigures(
    const std::vector<FluidFill<Dim>>& fluids, const std::vector<WallFill<Dim>>& walls,
    const ParticleSet<Dim>& particles, const Box<Dim>& domain, double spacing);

}  // namespace plenum
