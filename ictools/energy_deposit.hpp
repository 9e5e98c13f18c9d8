// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/initial_states.hpp"

#include <span>

namespace plenum {

/// Adds fluid.energyDeposit to the specific energies of an ideal gas and sets the pressures anew:
/// e_i += E W_i/sum_j m_j W_j, with the case's kernel about the point, h half the radius. So the
/// sum of m e grows by E to rounding. `positions` and `masses`: length n. Throws InputError if no
/// particle is in reach.
template <int Dim>
void depositEnergy(const FluidSettings& fluid, const SceneFrame<Dim>& frame,
                   std::span<const Vec<Dim>> positions, std::span<const double> masses,
                   const StateArrays& states);

}  // namespace plenum
