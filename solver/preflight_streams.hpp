// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "particles/scene.hpp"

namespace plenum {

/// Throws InputError, with the remedy, for inflows and outflows that the run's physics, its fluid
/// or its walls do not go with. Of a scene that goes on from a pause only the settings are checked.
template <int Dim>
void checkStreams(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles,
                  const SolverSettings& settings);

}  // namespace plenum
