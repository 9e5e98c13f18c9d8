// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which keys of [[fluid]] and [[wall]] go with which equation of state.
#pragma once

#include "ictools/ic_settings.hpp"

namespace plenum {

const Section<EnergyDepositSettings>& energyDepositSection();

/// Throws InputError for keys that the equation of state has no use for, and for an ideal gas that
/// does not say exactly once what its energy is.
void checkGasKeys(const FluidSettings& fluid, const SolverSettings& solver);

/// The same of a wall, which may leave its energy to the fluid's.
void checkGasKeys(const WallSettings& wall, const SolverSettings& solver);

}  // namespace plenum
