// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"
#include "particles/case_settings.hpp"

namespace plenum {

/// Moves fluid particles by -A h |v_i| dt times the gradient of their concentration
/// (term::Concentration), at most by a tenth of h: Lind et al. 2012, doi 10.1016/j.jcp.2011.10.027,
/// with the coefficient of Skillen et al. 2013, doi 10.1016/j.cma.2013.05.017, which does not
/// depend on the length of the step. Velocities and densities stay as they are. At a free surface,
/// where the neighbours of a particle stand on one side, nobody moves. Returns the longest way [m].
template <int Dim>
double shift(const ShiftingSettings& settings, double h, double dt, const Engine<Dim>& engine,
             ParticleSet<Dim>& particles);

}  // namespace plenum
