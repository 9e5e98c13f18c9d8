// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/simulation.hpp"

#include "particles/errors.hpp"
#include "particles/parallel.hpp"
#include "solver/preflight.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

std::vector<Tait> fluidStates(const std::vector<Material>& materials, const SolverSettings& s) {
  std::vector<Tait> rows;
  for (const Material& m : materials)
    rows.push_back({m.density, s.soundSpeed, s.backgroundPressure, s.taitExponent});
  return rows;
}

std::vector<Tait> wallStates(const std::vector<Wall>& walls, const SolverSettings& s) {
  std::vector<Tait> rows;
  for (const Wall& w : walls)
    rows.push_back({w.density, s.soundSpeed, s.backgroundPressure, s.taitExponent});
  return rows;
}

/// The scene itself, after the checks that everything else relies on.
template <int Dim>
Scene<Dim>& checked(Scene<Dim>& scene, const SolverSettings& settings) {
  checkBeforeRun(scene.info, scene.particles, settings);
  return scene;
}

template <int Dim>
typename Engine<Dim>::Options engineOptions(const SceneInfo<Dim>& info, const SolverSettings& s) {
  typename Engine<Dim>::Options options;
  options.support = 2 * s.smoothingLength * info.spacing;
  options.wallsReceive = !info.walls.empty() && s.wallPressure == "equation_of_state";
  return options;
}

}  // namespace

template <int Dim>
Simulation<Dim>::Simulation(Scene<Dim> scene, const SolverSettings& settings)
    : settings_(settings),
      info_(std::move(checked(scene, settings).info)),
      particles_(std::move(scene.particles)),
      engine_(info_.domain, engineOptions(info_, settings)),
      passes_(selectPasses<Dim>(settings, info_.spacing, particles_.nWalls() > 0)),
      materials_(fluidStates(info_.materials, settings)),
      wallMaterials_(wallStates(info_.walls, settings)),
      wallMotion_(info_.walls, particles_, info_.time) {
  for (int a = 0; a < Dim && !settings_.gravity.empty(); ++a)
    gravity_[a] = settings_.gravity[static_cast<std::size_t>(a)];
  info_.kernel = settings_.kernel;
  info_.smoothingLength = smoothingLength();

  const FieldSet needed = neededFields();
  particles_.add(needed);
  particles_.remove(particles_.fields().without(needed));
  updatePressure();
}

template <int Dim>
FieldSet Simulation<Dim>::neededFields() const {
  FieldSet needed{field::position, field::velocity, field::mass,
                  field::density,  field::pressure, field::id};
  if (particles_.nWalls() > 0) needed |= {field::wall, field::normal, field::wallDistance};
  if (info_.materials.size() > 1) needed |= {field::material};
  for (const auto* pass : {&passes_.density, &passes_.forces, &passes_.collisions})
    if (*pass) needed |= (*pass)->reads() | (*pass)->writes();
  return needed;
}

template <int Dim>
void Simulation<Dim>::step(double dt) {
  engine_.update(particles_);
  updateDensity(dt);
  updatePressure();
  passes_.forces->run(engine_, particles_);
  refuseNonFiniteForces();
  kick(dt);
  collide();
  drift(dt);
  info_.time += dt;
  ++nSteps_;
  wallMotion_.moveTo(time(), particles_);
}

/// Fluids, and walls too where they follow the fluid's equations.
template <int Dim>
std::size_t Simulation<Dim>::nDensityReceivers() const {
  return settings_.wallPressure == "equation_of_state" ? particles_.size() : particles_.nFluid();
}

template <int Dim>
void Simulation<Dim>::updateDensity(double dt) {
  passes_.density->run(engine_, particles_);
  if (!passes_.density->writes().has(field::densityRate)) return;
  const auto density = particles_[field::density];
  const auto rate = particles_[field::densityRate];
  forEachIndex(nDensityReceivers(), [&](std::size_t i) { density[i] += dt * rate[i]; });
}

template <int Dim>
void Simulation<Dim>::updatePressure() {
  const std::size_t nFluid = particles_.nFluid();
  const auto density = std::as_const(particles_)[field::density];
  const auto pressure = particles_[field::pressure];
  std::span<const std::int32_t> materialOf, wallOf;
  if (particles_.has(field::material)) materialOf = particles_[field::material];
  materials_.pressures(density.first(nFluid), materialOf, pressure.first(nFluid));
  if (particles_.nWalls() == 0) return;
  if (settings_.wallPressure == "zero") {
    std::ranges::fill(pressure.subspan(nFluid), 0.0);
  } else {
    wallOf = particles_[field::wall];
    wallMaterials_.pressures(density.subspan(nFluid), wallOf, pressure.subspan(nFluid));
  }
}

template <int Dim>
void Simulation<Dim>::refuseNonFiniteForces() const {
  const auto acceleration = particles_[field::acceleration];
  const std::size_t n = acceleration.size();
  std::size_t i = n;
#pragma omp parallel for schedule(static) reduction(min : i) if (n >= worthThreads)
  for (std::size_t k = 0; k < n; ++k)
    if (!std::isfinite(normSquared(acceleration[k]))) i = std::min(i, k);
  if (i == n) return;
  throw RunError(fmt::format(
      "the force on particle {} at ({:.4g}) is not finite at t = {:.6g} s, step {}: likely a time "
      "step that is too large or particles that overlap; try --set solver.time_step={:.2g}",
      particles_[field::id][i], fmt::join(particles_[field::position][i].components, ", "), time(),
      nSteps_, 0.05 * smoothingLength() / settings_.soundSpeed));
}

template <int Dim>
void Simulation<Dim>::kick(double dt) {
  const auto velocity = particles_[field::velocity];
  const auto acceleration = particles_[field::acceleration];
  forEachIndex(particles_.nFluid(),
               [&](std::size_t i) { velocity[i] += dt * (acceleration[i] + gravity_); });
}

template <int Dim>
void Simulation<Dim>::collide() {
  if (!passes_.collisions) return;
  passes_.collisions->run(engine_, particles_);
  const auto velocity = particles_[field::velocity];
  const auto change = particles_[field::velocityChange];
  forEachIndex(particles_.nFluid(), [&](std::size_t i) { velocity[i] += change[i]; });
}

template <int Dim>
void Simulation<Dim>::drift(double dt) {
  const auto position = particles_[field::position];
  const auto velocity = particles_[field::velocity];
  forEachIndex(particles_.nFluid(), [&](std::size_t i) {
    position[i] = info_.domain.wrap(position[i] + dt * velocity[i]);
  });
}

template <int Dim>
double Simulation<Dim>::maxTimeStep() const {
  if (settings_.timeStep) return *settings_.timeStep;
  const auto velocity = particles_[field::velocity];
  const auto acceleration = particles_[field::acceleration];
  const std::size_t n = particles_.nFluid();
  double speed = 0, force = 0;
#pragma omp parallel for schedule(static) reduction(max : speed, force) if (n >= worthThreads)
  for (std::size_t i = 0; i < n; ++i) {
    speed = std::max(speed, normSquared(velocity[i]));
    force = std::max(force, normSquared(acceleration[i] + gravity_));
  }
  const double h = smoothingLength();
  const double bySignal = h / (settings_.soundSpeed + std::sqrt(speed));
  const double byForce = force > 0 ? std::sqrt(h / std::sqrt(force)) : bySignal;
  return settings_.cfl * std::min(bySignal, byForce);
}

template <int Dim>
double Simulation<Dim>::bytesPerParticle() const {
  return particles_.bytesPerParticle() +
         static_cast<double>(engine_.bytes()) / static_cast<double>(particles_.size());
}

template class Simulation<1>;
template class Simulation<2>;
template class Simulation<3>;

}  // namespace plenum
