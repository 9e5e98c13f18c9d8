// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"

namespace plenum {

/// Gradient b of a sum that was made with neighbours which do not stand evenly, corrected by their
/// moments M (term::DensityGradient): M^-1 b. `diagonal` and `mixed` as field::momentDiagonal and
/// field::momentMixed. Zero where the neighbours lie (nearly) in a line or plane: there is no
/// gradient to be had.
template <int Dim>
Vec<Dim> correctedGradient(const Vec<Dim>& sum, const Vec<Dim>& diagonal, const Vec<Dim>& mixed);

/// Sets field::densityGradient of all particles that the pass names.
template <int Dim>
void updateDensityGradient(Engine<Dim>& engine, const PairPass<Dim>& pass,
                           ParticleSet<Dim>& particles);

}  // namespace plenum
