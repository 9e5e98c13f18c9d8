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

/// What a fluid or a wall starts with: a uniform pressure, or the hydrostatic one, dp/ddepth =
/// rho |g|, where depth is measured along gravity. Density and pressure belong to each other by the
/// Tait equation [C] (2.4), so that with gamma = 1 rho = rho_s exp(|g| depth/c^2), else
/// (rho/rho0)^(gamma-1) = (rho_s/rho0)^(gamma-1) + (gamma-1) |g| depth/c^2; rho_s is that of the
/// surface's pressure. To first order in |g| depth/c^2, p = p_surface + rho_s |g| depth.
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

  /// Of a pressure that is given. Throws InputError if no density belongs to it.
  FluidState withPressure(double pressure) const;

  /// Of a density that is given: the pressure is the uniform one if the table names it, else that
  /// of the equation of state.
  FluidState withDensity(double density) const;

 private:
  [[noreturn]] void failWithoutDensity(double pressure) const;

  SolverSettings solver_;
  double referenceDensity_;
  double pressure_;  ///< uniform, or at the surface
  bool isGiven_;     ///< by the table
  double surface_ = 0;
  double gravity_ = 0;  ///< |g| [m/s^2]; 0: uniform
  CaseNode table_;
};

}  // namespace plenum
