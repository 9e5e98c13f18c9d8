// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a scene and the settings of a run come to before the first step.
#pragma once

#include "engine/engine.hpp"
#include "particles/case_settings.hpp"
#include "particles/scene.hpp"
#include "solver/pair_pass.hpp"
#include "solver/phases.hpp"

namespace plenum {

/// soundSpeed: the largest [m/s], for the engine's units.
template <int Dim>
typename Engine<Dim>::Options engineOptions(const Scene<Dim>& scene, const SolverSettings& settings,
                                            double soundSpeed, bool measuresLoads);

/// The acceleration of gravity [m/s^2]; zero if the case has none.
template <int Dim>
Vec<Dim> gravityOf(const SolverSettings& settings);

/// The fields that the chosen physics needs, and no others.
template <int Dim>
FieldSet fieldsOf(const Scene<Dim>& scene, const SolverSettings& settings,
                  const StepPasses<Dim>& passes, bool wallsMove);

/// Adds these fields, where the particles lack them, and removes all others.
template <int Dim>
void keepFields(Scene<Dim>& scene, FieldSet fields);

/// Sets what each particle has from its material or, a wall, from the fluid of its density, where
/// the particles carry it.
template <int Dim>
void setConstants(Scene<Dim>& scene, const SolverSettings& settings, const Phases& phases);

}  // namespace plenum
