// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/ic_settings.hpp"
#include "particles/vec.hpp"

#include <optional>

namespace plenum {

/// Pressure [Pa m^(3-d)] and density [kg/m^d] of a particle at rest.
struct FluidState {
  double pressure = 0;
  double density = 0;
};

/// What a fluid or a wall starts with: a uniform pressure, or the hydrostatic one
/// p = p_surface + rho0 |g| depth, where depth is measured along gravity. The density follows from
/// the Tait equation [C] (2.4) turned round: rho = rho0 (1 + gamma (p - p0)/(rho0 c^2))^(1/gamma),
/// that is rho0 + (p - p0)/c^2 for gamma = 1.
class InitialState {
 public:
  /// `pressure` absent: p0, so that the density is rho0. `table` is the [[fluid]] or [[wall]], for
  /// messages. Throws InputError for a hydrostatic state without gravity.
  InitialState(const SolverSettings& solver, double referenceDensity,
               std::optional<double> pressure,
               const std::optional<HydrostaticSettings>& hydrostatic, const CaseNode& table);

  /// The same everywhere.
  bool isUniform() const { return !(gravity_ > 0); }

  /// Throws InputError if the pressure is so low that no density belongs to it.
  template <int Dim>
  FluidState operator()(const Vec<Dim>& x) const;

  /// Of a density that is given: the pressure is the uniform one if the table names it, else that
  /// of the equation of state.
  FluidState withDensity(double density) const;

 private:
  SolverSettings solver_;
  double referenceDensity_;
  double pressure_;  ///< uniform, or at the surface
  bool isGiven_;     ///< by the table
  double surface_ = 0;
  double gravity_ = 0;  ///< |g| [m/s^2]; 0: uniform
  CaseNode table_;
};

}  // namespace plenum
