// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/simulation.hpp"

#include <array>

namespace plenum {

/// Sums over all fluid particles; conserved where no wall acts.
struct Conserved {
  double mass = 0;                          ///< [kg]
  double kineticEnergy = 0;                 ///< [J]
  double potentialEnergy = 0;               ///< in gravity, zero at the origin [J]
  double compressionEnergy = 0;             ///< of the equation of state, zero at rho0 [J]
  double internalEnergy = 0;                ///< of an ideal gas, instead [J]
  std::array<double, 3> momentum{};         ///< [kg m/s]
  std::array<double, 3> angularMomentum{};  ///< about the origin [kg m^2/s]

  double energy() const {
    return kineticEnergy + potentialEnergy + compressionEnergy + internalEnergy;
  }
  Conserved& operator+=(const Conserved& other);
};

template <int Dim>
Conserved measureConserved(const Simulation<Dim>& simulation);

}  // namespace plenum
