// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "particles/scene.hpp"

namespace plenum {

/// Throws InputError for physics of gases and of smoothing lengths that do not go together, and for
/// particles without what they need.
template <int Dim>
void checkGas(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles,
              const SolverSettings& settings);

}  // namespace plenum
