// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/simulation.hpp"

#include "engine/derived_fields.hpp"
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

double squareOf(double x) { return x * x; }
template <int Dim>
double squareOf(const Vec<Dim>& v) {
  return normSquared(v);
}

constexpr auto isFiniteVector = [](const auto& v) { return std::isfinite(normSquared(v)); };

/// The largest |vector(i)|, i < n.
template <class Vector>
double largestNorm(std::size_t n, Vector&& vector) {
  double largest = 0;
#pragma omp parallel for schedule(static) reduction(max : largest) if (n >= worthThreads)
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, normSquared(vector(i)));
  return std::sqrt(largest);
}

/// The scene itself, after the checks that everything else relies on.
template <int Dim>
Scene<Dim>& checked(Scene<Dim>& scene, const SolverSettings& settings) {
  checkBeforeRun(scene.info, scene.particles, settings);
  return scene;
}

template <int Dim>
typename Engine<Dim>::Options engineOptions(const Scene<Dim>& scene, const SolverSettings& s) {
  const SceneInfo<Dim>& info = scene.info;
  typename Engine<Dim>::Options options;
  options.support = 2 * s.smoothingLength * info.spacing;
  options.wallsReceive = !info.walls.empty() && s.wallsEvolve();
  options.precision = s.precision == "double" ? Precision::doubled : Precision::mixed;
  options.units =
      Units::near(s.smoothingLength * info.spacing, scene.particles[field::mass][0], s.soundSpeed);
  return options;
}

}  // namespace

template <int Dim>
Simulation<Dim>::Simulation(Scene<Dim> scene, const SolverSettings& settings)
    : settings_(settings),
      scene_(std::move(checked(scene, settings))),
      engine_(scene_.info.domain, engineOptions(scene_, settings)),
      passes_(selectPasses<Dim>(settings, scene_.info.spacing, scene_.particles.nWalls() > 0,
                                engine_.units())),
      materials_(fluidStates(scene_.info.materials, settings)),
      wallMaterials_(wallStates(scene_.info.walls, settings)),
      wallMotion_(scene_) {
  for (int a = 0; a < Dim && !settings_.gravity.empty(); ++a)
    gravity_[a] = settings_.gravity[static_cast<std::size_t>(a)];
  scene_.info.kernel = settings_.kernel;
  scene_.info.smoothingLength = smoothingLength();

  largestAcceleration_ = norm(gravity_);
  fastest_ = largestNorm(scene_.particles.nFluid(), [&](std::size_t i) {
    return std::as_const(scene_.particles)[field::velocity][i];
  });
  const FieldSet needed = neededFields();
  scene_.particles.add(needed);
  scene_.particles.remove(scene_.particles.fields().without(needed));
  engine_.update(scene_.particles);
  if (settings_.density == "summation") updateDensity(0);  // the first state shown is the run's own
  updatePressure();
}

template <int Dim>
FieldSet Simulation<Dim>::neededFields() const {
  FieldSet needed{field::position, field::velocity, field::mass,
                  field::density,  field::pressure, field::id};
  if (scene_.particles.nWalls() > 0) needed |= {field::wall, field::normal, field::wallDistance};
  if (wallMotion_.anyMoves()) needed |= {field::referencePosition, field::referenceNormal};
  if (scene_.info.materials.size() > 1) needed |= {field::material};
  for (const auto* pass : {&passes_.density, &passes_.forces, &passes_.collisions})
    if (*pass) needed |= storedFor(pass->reads);
  return needed;
}

template <int Dim>
void Simulation<Dim>::step(double dt) {
  engine_.update(scene_.particles);
  updateDensity(dt);
  updatePressure();
  engine_.run(passes_.forces, scene_.particles);
  kick(dt);
  collide();
  drift(dt);
  scene_.info.time += dt;
  ++nSteps_;
  engine_.moved(wallMotion_.moveTo(time(), scene_.particles));
}

template <int Dim>
void Simulation<Dim>::updateDensity(double dt) {
  engine_.run(passes_.density, scene_.particles);
  const auto integrating = engine_.stopwatch().lap(Part::integrate);
  const auto density = scene_.particles[field::density];
  const bool wallsToo = settings_.wallsEvolve();
  if (passes_.density.writes.has(field::density))
    engine_.withSums(field::density, [&](const auto& sums) {
      forEachIndex(sums.nClusters(wallsToo), [&](std::size_t c) {
        sums.forEach(c, [&](std::size_t i, double sum) { density[i] = sum; });
      });
    });
  else
    engine_.withSums(field::velocityDivergence, [&](const auto& divergences) {
      advance(
          density, divergences, wallsToo, "the density is no longer positive and finite",
          [&](std::size_t, double rho, double div) { return rho * (1 - dt * div); },
          [&](std::size_t, double rho, double div) { return rho / (1 - dt * div); },
          [](double rho) { return rho > 0 && std::isfinite(rho); });
    });
}

template <int Dim>
void Simulation<Dim>::updatePressure() {
  const auto integrating = engine_.stopwatch().lap(Part::integrate);
  const std::size_t nFluid = scene_.particles.nFluid();
  const auto density = std::as_const(scene_.particles)[field::density];
  const auto pressure = scene_.particles[field::pressure];
  std::span<const std::int32_t> materialOf, wallOf;
  if (scene_.particles.has(field::material)) materialOf = scene_.particles[field::material];
  materials_.pressures(density.first(nFluid), materialOf, pressure.first(nFluid));
  if (scene_.particles.nWalls() == 0) return;
  if (settings_.wallsEvolve()) {
    wallOf = scene_.particles[field::wall];
    wallMaterials_.pressures(density.subspan(nFluid), wallOf, pressure.subspan(nFluid));
  } else {
    std::ranges::fill(pressure.subspan(nFluid), 0.0);
  }
}

/// values[i] = next(i, values[i], sum of i) for all fluids, or for walls too. If some result is not
/// sound, takes all back by `previous` (to rounding) and throws RunError that names the first one.
/// Returns the largest |change|.
template <int Dim>
template <class Value, class Sums, class Next, class Previous, class IsSound>
double Simulation<Dim>::advance(std::span<Value> values, const Sums& sums, bool wallsToo,
                                const char* what, Next&& next, Previous&& previous,
                                IsSound&& isSound) {
  const std::size_t nClusters = sums.nClusters(wallsToo), none = values.size();
  std::size_t bad = none;
  double largest = 0;
#pragma omp parallel for schedule(static) reduction(min    \
                                                    : bad) \
    reduction(max                                          \
              : largest) if (none >= worthThreads)
  for (std::size_t c = 0; c < nClusters; ++c)
    sums.forEach(c, [&](std::size_t i, const auto& sum) {
      const Value value = next(i, values[i], sum);
      if (isSound(value)) {
        largest = std::max(largest, squareOf(value - values[i]));
        values[i] = value;
      } else {
        bad = std::min(bad, i);
      }
    });
  if (bad == none) return std::sqrt(largest);
  for (std::size_t c = 0; c < nClusters; ++c)
    sums.forEach(c, [&](std::size_t i, const auto& sum) {
      const Value value = previous(i, values[i], sum);
      if (isSound(value)) values[i] = value;  // else it was not changed
    });
  fail(what, bad);
}

template <int Dim>
void Simulation<Dim>::fail(const char* what, std::size_t i) const {
  const ParticleSet<Dim>& particles = scene_.particles;
  throw RunError(fmt::format(
      "particle {} at ({:.4g}): {} at t = {:.6g} s, step {}: likely a time step that is too large "
      "or particles that overlap; try --set solver.time_step={:.2g}",
      particles[field::id][i], fmt::join(particles[field::position][i].components, ", "), what,
      time(), nSteps_, 0.05 * smoothingLength() / settings_.soundSpeed));
}

template <int Dim>
void Simulation<Dim>::kick(double dt) {
  const auto integrating = engine_.stopwatch().lap(Part::integrate);
  const auto velocity = scene_.particles[field::velocity];
  const auto mass = std::as_const(scene_.particles)[field::mass];
  engine_.withSums(field::force, [&](const auto& forces) {
    const auto acceleration = [&](std::size_t i, const Vec<Dim>& force) {
      return (1 / mass[i]) * force + gravity_;
    };
    const double largestChange = advance(
        velocity, forces, false, "the force is not finite",
        [&](std::size_t i, const Vec<Dim>& v, const Vec<Dim>& force) {
          return v + dt * acceleration(i, force);
        },
        [&](std::size_t i, const Vec<Dim>& v, const Vec<Dim>& force) {
          return v - dt * acceleration(i, force);
        },
        isFiniteVector);
    largestAcceleration_ = largestChange / dt;
  });
}

template <int Dim>
void Simulation<Dim>::collide() {
  if (!passes_.collisions) return;
  engine_.run(passes_.collisions, scene_.particles);
  const auto integrating = engine_.stopwatch().lap(Part::integrate);
  const auto mass = std::as_const(scene_.particles)[field::mass];
  engine_.withSums(field::impulse, [&](const auto& impulses) {
    advance(
        scene_.particles[field::velocity], impulses, false,
        "the change of velocity by collisions is not finite",
        [&](std::size_t i, const Vec<Dim>& v, const Vec<Dim>& impulse) {
          return v + (1 / mass[i]) * impulse;
        },
        [&](std::size_t i, const Vec<Dim>& v, const Vec<Dim>& impulse) {
          return v - (1 / mass[i]) * impulse;
        },
        isFiniteVector);
  });
}

template <int Dim>
void Simulation<Dim>::drift(double dt) {
  const auto integrating = engine_.stopwatch().lap(Part::integrate);
  const auto position = scene_.particles[field::position];
  const auto velocity = std::as_const(scene_.particles)[field::velocity];
  const Box<Dim>& domain = scene_.info.domain;
  const std::size_t n = scene_.particles.nFluid();
  fastest_ = largestNorm(n, [&](std::size_t i) {
    position[i] += dt * velocity[i];
    return velocity[i];
  });
  if (domain.anyPeriodic())
    forEachIndex(n, [&](std::size_t i) {
      if (!domain.contains(position[i])) position[i] = domain.wrap(position[i]);
    });
  engine_.moved(dt * fastest_);
}

template <int Dim>
double Simulation<Dim>::maxTimeStep() const {
  if (settings_.timeStep) return *settings_.timeStep;
  const double h = smoothingLength(), speed = fastest_;
  const double bySignal = h / (settings_.soundSpeed + speed);
  const double byForce = largestAcceleration_ > 0 ? std::sqrt(h / largestAcceleration_) : bySignal;
  const double step = settings_.cfl * std::min(bySignal, byForce);
  if (!(step > 1e-6 * h / settings_.soundSpeed)) {
    const auto velocity = scene_.particles[field::velocity].first(scene_.particles.nFluid());
    const auto isFastest = [&](const Vec<Dim>& v) { return norm(v) >= speed; };
    fail("the fastest of all, makes the cfl time step fall below a millionth of h/c",
         static_cast<std::size_t>(std::ranges::find_if(velocity, isFastest) - velocity.begin()));
  }
  return step;
}

template <int Dim>
double Simulation<Dim>::bytesPerParticle() const {
  return scene_.particles.bytesPerParticle() +
         static_cast<double>(engine_.bytes()) / static_cast<double>(scene_.particles.size());
}

template class Simulation<1>;
template class Simulation<2>;
template class Simulation<3>;

}  // namespace plenum
