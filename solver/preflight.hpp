// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "particles/scene.hpp"

namespace plenum {

/// Throws InputError, with the remedy, for a particle set that these settings cannot run:
/// no fluid, fields missing, masses or densities that are not positive, positions that are not
/// finite, smoothing lengths that differ, walls thinner than the kernel's support, collisions that
/// reach beyond it.
template <int Dim>
void checkBeforeRun(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles,
                    const SolverSettings& settings);

}  // namespace plenum
