// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tunnel of gas with an inflow and an outflow.
#pragma once

#include "particles/scene.hpp"
#include "solver/simulation.hpp"

#include <cmath>

namespace plenum::test {

inline constexpr double gammaOfGas = 1.4;

/// Ends at x = 1 and x = 3 of a tunnel whose gas reaches from 0 to 4.
inline SolverSettings tunnelSettings() {
  SolverSettings settings;
  settings.equationOfState = "ideal_gas";
  settings.adiabaticIndex = gammaOfGas;
  settings.integrator = "kick_drift_kick";
  settings.precision = "double";
  settings.adaptive = AdaptiveSettings{};
  settings.viscosity = ViscositySettings{.monaghan = MonaghanSettings{1, 2, true}};
  settings.inflows = {{"x", 1, "lower", 1}};
  settings.outflows = {{"x", 3, "upper", 1}};
  return settings;
}

/// A lattice of 16 a metre in a tunnel of .5 m width whose rows stand an eighth of a spacing
/// further each, so that 8 of them close over the period; sound speed 1 and a wind of `mach`.
/// Masses are powers of two.
template <int Dim>
Scene<Dim> tunnel(double mach) {
  Scene<Dim> scene;
  scene.info.title = "tunnel";
  scene.info.caseName = "tunnel.toml";
  const double a = scene.info.spacing = 1.0 / 16;
  scene.info.domain.upper = Vec<Dim>::filled(0.5);
  scene.info.domain.upper[0] = 4;
  scene.info.domain.periodic.fill(true);
  scene.info.domain.periodic[0] = false;
  scene.info.materials = {{"gas", 1.0}};
  const std::size_t nRows = Dim == 1 ? 1 : Dim == 2 ? 8 : 64, n = 64 * nRows;
  ParticleSet<Dim>& p = scene.particles;
  p = ParticleSet<Dim>({field::position, field::velocity, field::mass, field::density, field::id,
                        field::internalEnergy},
                       n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const auto column = static_cast<double>(i / nRows), row = static_cast<double>(i % nRows);
    p[field::position][i][0] = a * (column + std::fmod(0.3 + 0.125 * row, 1));
    if constexpr (Dim > 1) p[field::position][i][1] = a * (std::fmod(row, 8) + 0.5);
    if constexpr (Dim > 2) p[field::position][i][2] = a * (std::floor(row / 8) + 0.5);
    p[field::velocity][i][0] = mach;
    p[field::mass][i] = std::pow(a, Dim);
    p[field::density][i] = 1;
    p[field::internalEnergy][i] = 1 / (gammaOfGas * (gammaOfGas - 1));
    p[field::id][i] = 1 + i;
  }
  return scene;
}

/// Gas with a hump of pressure in the middle, which waves run away from.
inline Scene<2> hump(double mach) {
  Scene<2> scene = tunnel<2>(mach);
  ParticleSet<2>& p = scene.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    p[field::internalEnergy][i] *=
        1 + std::exp(-60 * normSquared(p[field::position][i] - Vec<2>{{2, 0.25}}));
  return scene;
}

template <int Dim>
void advance(Simulation<Dim>& simulation, double target) {
  simulation.advanceTo(target, [] {});
}

}  // namespace plenum::test
