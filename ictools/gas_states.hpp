// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/initial_states.hpp"

namespace plenum {

/// The states of an isothermal or an ideal gas: the density is the given one or the profile's;
/// p = c^2 rho, or e from pressure, energy or temperature, and an energy deposit is not in yet.
template <int Dim>
InitialStatesPtr<Dim> gasStates(const FluidFill<Dim>& fluid, const SolverSettings& solver);

/// Of a wall: with the density of the wall, and the pressure or energy of the fluid `like` unless
/// the wall names one.
template <int Dim>
InitialStatesPtr<Dim> gasStates(const WallFill<Dim>& wall, const FluidSettings& like,
                                const SolverSettings& solver);

}  // namespace plenum
