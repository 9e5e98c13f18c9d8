// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "particles/scene.hpp"
#include "solver/stream_planes.hpp"

namespace plenum {

/// Throws InputError, with the remedy, where the fluid or the walls of a scene do not go with one
/// of its inflows or outflows.
template <int Dim>
void checkPlane(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles,
                const SolverSettings& settings, const StreamPlane<Dim>& plane);

}  // namespace plenum
