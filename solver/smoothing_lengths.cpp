// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/smoothing_lengths.hpp"

#include "particles/errors.hpp"
#include "particles/number.hpp"
#include "particles/parallel.hpp"
#include "particles/self_term.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

/// A length changes by at most this factor in an iteration: Newton's method may start far away.
constexpr double largestChange = 1.3;

constexpr double unlimited = std::numeric_limits<double>::infinity();

}  // namespace

template <int Dim>
SmoothingLengths<Dim>::SmoothingLengths(const SolverSettings& settings)
    : settings_(settings.adaptive.value_or(AdaptiveSettings{})),
      isAdaptive_(settings.lengthsFollow()),
      isGradH_(settings.hasForm("grad_h")),
      eta_(settings.smoothingLength),
      selfTerm_(selfTermCorrection(settings, Dim)),
      planes_(settings) {}

template <int Dim>
void SmoothingLengths<Dim>::begin(Engine<Dim>& engine, const StepPasses<Dim>& passes,
                                  ParticleSet<Dim>& particles) const {
  if (!isAdaptive_ || isGradH_) {
    update(engine, passes, particles);
    return;
  }
  constexpr int most = 10;  // of densities that jump, h from the mean density settles in as many
  sumDensities(engine, passes.density, particles);
  for (int k = 0; k < most; ++k) followMeanDensity(engine, passes, particles, unlimited);
}

template <int Dim>
int SmoothingLengths<Dim>::update(Engine<Dim>& engine, const StepPasses<Dim>& passes,
                                  ParticleSet<Dim>& particles) const {
  if (isGradH_) return updateFromOwnDensity(engine, passes, particles);
  sumDensities(engine, passes.density, particles);
  if (!isAdaptive_) return 1;
  followMeanDensity(engine, passes, particles, settings_.changeLimit.value_or(unlimited));
  return 2;
}

/// One step towards lengths and densities that fit the mean density.
template <int Dim>
void SmoothingLengths<Dim>::followMeanDensity(Engine<Dim>& engine, const StepPasses<Dim>& passes,
                                              ParticleSet<Dim>& particles,
                                              double changeLimit) const {
  engine.grew(updateFromMeanDensity(engine, passes.densityMoment, particles, changeLimit));
  engine.update(particles);
  sumDensities(engine, passes.density, particles);
}

template <int Dim>
void SmoothingLengths<Dim>::sumDensities(Engine<Dim>& engine, const PairPass<Dim>& density,
                                         ParticleSet<Dim>& particles) const {
  engine.run(density, particles);
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const auto rho = particles[field::density], omegaRho = particles[field::omegaDensity];
  const auto mass = std::as_const(particles)[field::mass];
  const auto h = std::as_const(particles)[field::smoothingLength];
  const auto position = std::as_const(particles)[field::position];
  engine.forEachSum(
      Group::fluids,
      [&](std::size_t i, double sum, double omegaSum) {
        const bool isSum = !planes_.isDeep(position[i]);
        if (isSum) rho[i] = sum - selfTerm_ * mass[i] / power<Dim>(h[i]);
        omegaRho[i] = isSum && isGradH_ ? omegaSum : rho[i];
      },
      field::density, field::omegaDensity);
}

/// One step of Newton's method for rho(h) = m (eta/h)^d, whose left side has the slope
/// -(d/h)(rho - Omega rho). Densities take the value that belongs to the new length, which the sum
/// would have but for an error of second order.
template <int Dim>
typename SmoothingLengths<Dim>::Correction SmoothingLengths<Dim>::correct(
    ParticleSet<Dim>& particles) const {
  const std::size_t n = particles.nFluid();
  const auto rho = particles[field::density], h = particles[field::smoothingLength];
  const auto omegaRho = particles[field::omegaDensity];
  const auto mass = std::as_const(particles)[field::mass];
  const auto position = std::as_const(particles)[field::position];
  double largest = 0, growth = 1;
#pragma omp parallel for schedule(static) reduction(max : largest, growth) if (n >= worthThreads)
  for (std::size_t i = 0; i < n; ++i) {
    if (planes_.isDeep(position[i])) continue;
    const double wanted = mass[i] * power<Dim>(eta_ / h[i]);
    const double slope = Dim * (omegaRho[i] + wanted - rho[i]);  // of the difference, times -h
    double change = (rho[i] - wanted) / slope;
    if (!(slope > 0)) change = std::pow(wanted / rho[i], -1.0 / Dim) - 1;
    const double factor = std::clamp(1 - change, 1 / largestChange, largestChange);
    largest = std::max(largest, std::abs(factor - 1));
    growth = std::max(growth, factor);
    h[i] *= factor;
    const double consistent = mass[i] * power<Dim>(eta_ / h[i]);
    omegaRho[i] *= consistent / rho[i];
    rho[i] = consistent;
  }
  return {Dim * largest * largest, growth};
}

template <int Dim>
int SmoothingLengths<Dim>::updateFromOwnDensity(Engine<Dim>& engine, const StepPasses<Dim>& passes,
                                                ParticleSet<Dim>& particles) const {
  for (int k = 1; k <= settings_.maxIterations; ++k) {
    sumDensities(engine, passes.density, particles);
    const Correction correction = correct(particles);
    engine.grew(correction.growth);
    const bool isDone = correction.error <= settings_.tolerance;
    if (!isDone || correction.growth > 1 + engine.lengthSkin()) engine.update(particles);
    if (isDone) return k;
  }
  sumDensities(engine, passes.density, particles);
  failToConverge(particles);
}

template <int Dim>
void SmoothingLengths<Dim>::failToConverge(const ParticleSet<Dim>& particles) const {
  const auto errorOf = [&](std::size_t i) {
    const double wanted =
        particles[field::mass][i] * power<Dim>(eta_ / particles[field::smoothingLength][i]);
    return std::abs(particles[field::density][i] / wanted - 1);
  };
  std::size_t worst = 0;
  for (std::size_t i = 1; i < particles.nFluid(); ++i)
    if (!(errorOf(i) <= errorOf(worst))) worst = i;
  throw RunError(fmt::format(
      "particle {} at ({:.4g}): its smoothing length {:.4g} m does not converge: after {} "
      "iterations "
      "its density {:.4g} is {:.2g} of itself away from what belongs to that length: likely it has "
      "lost its "
      "neighbours; raise solver.adaptive.max_iterations or tolerance, or smoothing_length",
      particles[field::id][worst], fmt::join(particles[field::position][worst].components, ", "),
      particles[field::smoothingLength][worst], settings_.maxIterations,
      particles[field::density][worst], errorOf(worst)));
}

template <int Dim>
double SmoothingLengths<Dim>::updateFromMeanDensity(Engine<Dim>& engine,
                                                    const PairPass<Dim>& densityMoment,
                                                    ParticleSet<Dim>& particles,
                                                    double changeLimit) const {
  engine.run(densityMoment, particles);
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const auto h = particles[field::smoothingLength];
  const auto rho = std::as_const(particles)[field::density];
  const auto mass = std::as_const(particles)[field::mass];
  const auto position = std::as_const(particles)[field::position];
  const double least = std::max(0.0, 1 - changeLimit), most = 1 + changeLimit;
  double growth = 1;
  engine.withSums(field::densityMoment, [&](const auto& moments) {
    const std::size_t nClusters = moments.nClusters(false);
#pragma omp parallel for schedule(static) reduction(max : growth) if (h.size() >= worthThreads)
    for (std::size_t c = 0; c < nClusters; ++c)
      moments.forEach(c, [&](std::size_t i, double moment) {
        if (planes_.isDeep(position[i])) return;
        const double wanted = eta_ * std::pow(mass[i] * rho[i] / moment, 1.0 / Dim);
        const double factor = std::clamp(wanted / h[i], least, most);
        growth = std::max(growth, factor);
        h[i] *= factor;
      });
  });
  return growth;
}

template <int Dim>
void SmoothingLengths<Dim>::predict(Engine<Dim>& engine, ParticleSet<Dim>& particles,
                                    double dt) const {
  if (!isGradH_) return;
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const std::size_t n = particles.nFluid();
  const auto h = particles[field::smoothingLength];
  const auto divergence = std::as_const(particles)[field::velocityDivergence];
  const auto position = std::as_const(particles)[field::position];
  double growth = 1;
#pragma omp parallel for schedule(static) reduction(max : growth) if (n >= worthThreads)
  for (std::size_t i = 0; i < n; ++i) {
    if (planes_.isDeep(position[i])) continue;
    const double factor =
        std::clamp(std::exp(dt * divergence[i] / Dim), 1 / largestChange, largestChange);
    growth = std::max(growth, factor);
    h[i] *= factor;
  }
  engine.grew(growth);
}

template class SmoothingLengths<1>;
template class SmoothingLengths<2>;
template class SmoothingLengths<3>;

}  // namespace plenum
