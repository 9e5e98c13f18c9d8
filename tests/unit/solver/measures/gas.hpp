// SPDX-License-Identifier: GPL-3.0-or-later
//
// Gases whose measures are known.
#pragma once

#include "tests/unit/solver/measures/water.hpp"

namespace plenum::test {

inline SolverSettings idealGas(double gamma) {
  SolverSettings settings;
  settings.equationOfState = "ideal_gas";
  settings.adiabaticIndex = gamma;
  return settings;
}

inline SolverSettings isothermalGas(double soundSpeed) {
  SolverSettings settings;
  settings.equationOfState = "isothermal";
  settings.soundSpeed = soundSpeed;
  return settings;
}

/// Gas of density 1 at rest on a cubic lattice that fills [-half, half]^Dim, at cell centres.
template <int Dim>
Scene<Dim> gasBox(double half, double spacing) {
  Scene<Dim> water = stillWater<Dim>(Vec<Dim>::filled(2 * half), spacing);
  Scene<Dim> scene;
  scene.info = water.info;
  scene.info.materials = {{"gas", 1}};
  scene.info.domain = Box<Dim>{Vec<Dim>::filled(-half), Vec<Dim>::filled(half), {}};
  const FieldSet fields{field::position, field::velocity,       field::mass, field::density,
                        field::pressure, field::internalEnergy, field::id};
  scene.particles = ParticleSet<Dim>(fields, water.particles.nFluid(), 0);
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    scene.particles[field::position][i] =
        water.particles[field::position][i] - Vec<Dim>::filled(half);
    scene.particles[field::density][i] = 1;
    scene.particles[field::mass][i] = std::pow(spacing, Dim);
  }
  return scene;
}

/// Gives a particle a density and keeps its volume.
template <int Dim>
void setDensity(ParticleSet<Dim>& particles, std::size_t i, double density) {
  particles[field::mass][i] *= density / particles[field::density][i];
  particles[field::density][i] = density;
}

/// As a run with h = 1.5 d_ref sees it; `settings` must outlive the view.
template <int Dim>
Observed<Dim> observedGas(const Scene<Dim>& scene, const SolverSettings& settings) {
  return {scene.particles,          scene.info, settings, KernelId::named("wendland_c2"),
          1.5 * scene.info.spacing, {}};
}

/// The row that a measure writes.
template <int Dim, class Measure>
std::vector<Figure> rowOf(const Measure& measure, const Scene<Dim>& scene,
                          const SolverSettings& settings) {
  std::vector<Figure> row;
  measure.addTo(row, observedGas(scene, settings));
  return row;
}

}  // namespace plenum::test
