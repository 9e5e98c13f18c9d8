// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace plenum {

inline constexpr double boltzmannConstant = 1.380649e-23;  ///< [J/K], exact (SI of 2019)
inline constexpr double hydrogenMass = 1.67353284e-27;     ///< [kg]: 1.00782503 u, CODATA 2018

/// Specific internal energy [J/kg] at a pressure [Pa m^(3-d)] and density [kg/m^d]:
/// e = p/((gamma - 1) rho).
inline double energyOfPressure(double pressure, double density, double adiabaticIndex) {
  return pressure / ((adiabaticIndex - 1) * density);
}

/// Pressure [Pa m^(3-d)] at a specific internal energy [J/kg]: p = (gamma - 1) rho e.
inline double pressureOfEnergy(double energy, double density, double adiabaticIndex) {
  return (adiabaticIndex - 1) * density * energy;
}

/// Specific internal energy [J/kg] at a temperature [K], of particles with a mean mass of
/// `molecularWeight` hydrogen atoms: from p = rho k_B T/(nu m_H).
inline double energyOfTemperature(double temperature, double molecularWeight,
                                  double adiabaticIndex) {
  return boltzmannConstant * temperature / ((adiabaticIndex - 1) * molecularWeight * hydrogenMass);
}

}  // namespace plenum
