// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/integrate.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plenum {

namespace {

constexpr auto isPositive = [](double x) { return x > 0 && std::isfinite(x); };
constexpr auto isFiniteVector = [](const auto& v) { return std::isfinite(normSquared(v)); };

double squareOf(double x) { return x * x; }
template <int Dim>
double squareOf(const Vec<Dim>& v) {
  return normSquared(v);
}

/// values[i] = next(i, values[i], sum of i) for all fluids, or for walls too. If some result is not
/// sound, all are taken back by `previous`.
template <class Value, class Sums, class Next, class Previous, class IsSound>
Advanced advance(std::span<Value> values, const Sums& sums, bool wallsToo, Next&& next,
                 Previous&& previous, IsSound&& isSound) {
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
  if (bad == none) return {std::sqrt(largest), std::nullopt};
  for (std::size_t c = 0; c < nClusters; ++c)
    sums.forEach(c, [&](std::size_t i, const auto& sum) {
      const Value value = previous(i, values[i], sum);
      if (isSound(value)) values[i] = value;  // else it was not changed
    });
  return {0, bad};
}

/// v <- v + change(i, sum) by the sums of a field.
template <int Dim, class Field, class Change>
Advanced advanceVelocities(Engine<Dim>& engine, ParticleSet<Dim>& particles, Field summed,
                           Change&& change) {
  Advanced result;
  engine.withSums(summed, [&](const auto& sums) {
    result = advance(
        particles[field::velocity], sums, false,
        [&](std::size_t i, const Vec<Dim>& v, const Vec<Dim>& sum) { return v + change(i, sum); },
        [&](std::size_t i, const Vec<Dim>& v, const Vec<Dim>& sum) { return v - change(i, sum); },
        isFiniteVector);
  });
  return result;
}

}  // namespace

template <int Dim>
Advanced advanceDensities(Engine<Dim>& engine, ParticleSet<Dim>& particles, double dt,
                          bool wallsToo) {
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  Advanced result;
  engine.withSums(field::velocityDivergence, [&](const auto& divergences) {
    result = advance(
        particles[field::density], divergences, wallsToo,
        [&](std::size_t, double rho, double div) { return rho * (1 - dt * div); },
        [&](std::size_t, double rho, double div) { return rho / (1 - dt * div); }, isPositive);
  });
  return result;
}

template <int Dim>
void takeSummedDensities(Engine<Dim>& engine, ParticleSet<Dim>& particles, bool wallsToo) {
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const auto density = particles[field::density];
  engine.forEachSum(
      wallsToo ? Group::all : Group::fluids, [&](std::size_t i, double sum) { density[i] = sum; },
      field::density);
}

template <int Dim>
Advanced kick(Engine<Dim>& engine, ParticleSet<Dim>& particles, const Vec<Dim>& gravity,
              double dt) {
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const std::span<const double> mass = std::as_const(particles)[field::mass];
  return advanceVelocities(
      engine, particles, field::force,
      [&](std::size_t i, const Vec<Dim>& force) { return dt * ((1 / mass[i]) * force + gravity); });
}

template <int Dim>
Advanced storeAccelerations(Engine<Dim>& engine, ParticleSet<Dim>& particles,
                            const Vec<Dim>& gravity) {
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const std::span<const double> mass = std::as_const(particles)[field::mass];
  const auto stored = particles[field::acceleration];
  Advanced result;
  engine.withSums(field::force, [&](const auto& forces) {
    result = advance(
        stored, forces, false,
        [&](std::size_t i, const Vec<Dim>&, const Vec<Dim>& force) {
          return (1 / mass[i]) * force + gravity;
        },
        [&](std::size_t i, const Vec<Dim>&, const Vec<Dim>&) { return stored[i]; }, isFiniteVector);
  });
  return result;
}

template <int Dim>
void kickByAccelerations(Engine<Dim>& engine, ParticleSet<Dim>& particles, double dt) {
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const auto velocity = particles[field::velocity];
  const auto acceleration = std::as_const(particles)[field::acceleration];
  forEachIndex(acceleration.size(), [&](std::size_t i) { velocity[i] += dt * acceleration[i]; });
}

template <int Dim>
Advanced heat(Engine<Dim>& engine, ParticleSet<Dim>& particles, double dt) {
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const auto energy = particles[field::internalEnergy];
  const auto rate = std::as_const(particles)[field::internalEnergyRate];
  const std::size_t none = rate.size();
  std::size_t bad = none;
#pragma omp parallel for schedule(static) reduction(min : bad) if (none >= worthThreads)
  for (std::size_t i = 0; i < none; ++i)
    if (!isPositive(energy[i] + dt * rate[i])) bad = std::min(bad, i);
  if (bad != none) return {0, bad};
  forEachIndex(none, [&](std::size_t i) { energy[i] += dt * rate[i]; });
  return {};
}

template <int Dim>
Advanced takeImpulses(Engine<Dim>& engine, ParticleSet<Dim>& particles) {
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const std::span<const double> mass = std::as_const(particles)[field::mass];
  return advanceVelocities(
      engine, particles, field::impulse,
      [&](std::size_t i, const Vec<Dim>& impulse) { return (1 / mass[i]) * impulse; });
}

template <int Dim>
void drift(Engine<Dim>& engine, const Box<Dim>& domain, ParticleSet<Dim>& particles, double dt,
           double fastest) {
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const auto position = particles[field::position];
  const auto velocity = std::as_const(particles)[field::velocity];
  forEachIndex(particles.nFluid(), [&](std::size_t i) { position[i] += dt * velocity[i]; });
  wrapPositions(domain, particles);
  engine.moved(dt * fastest);
}

template <int Dim>
void wrapPositions(const Box<Dim>& domain, ParticleSet<Dim>& particles) {
  if (!domain.anyPeriodic()) return;
  const auto position = particles[field::position].first(particles.nFluid());
  forEachIndex(position.size(), [&](std::size_t i) {
    if (!domain.contains(position[i])) position[i] = domain.wrap(position[i]);
  });
}

template <int Dim>
double largestNorm(std::span<const Vec<Dim>> vectors) {
  double largest = 0;
#pragma omp parallel for schedule(static) reduction(max \
                                                    : largest) if (vectors.size() >= worthThreads)
  for (std::size_t i = 0; i < vectors.size(); ++i)
    largest = std::max(largest, normSquared(vectors[i]));
  return std::sqrt(largest);
}

#define PLENUM_INSTANTIATE(Dim)                                                           \
  template Advanced advanceDensities(Engine<Dim>&, ParticleSet<Dim>&, double, bool);      \
  template void takeSummedDensities(Engine<Dim>&, ParticleSet<Dim>&, bool);               \
  template Advanced kick(Engine<Dim>&, ParticleSet<Dim>&, const Vec<Dim>&, double);       \
  template Advanced storeAccelerations(Engine<Dim>&, ParticleSet<Dim>&, const Vec<Dim>&); \
  template void kickByAccelerations(Engine<Dim>&, ParticleSet<Dim>&, double);             \
  template Advanced heat(Engine<Dim>&, ParticleSet<Dim>&, double);                        \
  template Advanced takeImpulses(Engine<Dim>&, ParticleSet<Dim>&);                        \
  template void drift(Engine<Dim>&, const Box<Dim>&, ParticleSet<Dim>&, double, double);  \
  template void wrapPositions(const Box<Dim>&, ParticleSet<Dim>&);                        \
  template double largestNorm(std::span<const Vec<Dim>>);
PLENUM_INSTANTIATE(1)
PLENUM_INSTANTIATE(2)
PLENUM_INSTANTIATE(3)
#undef PLENUM_INSTANTIATE

}  // namespace plenum
