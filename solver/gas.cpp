// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/gas.hpp"

#include "particles/number.hpp"
#include "particles/parallel.hpp"
#include "solver/scene_setup.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// Coefficients of the viscosities of a scene, for the time step: linear and quadratic.
struct ViscosityStrength {
  double linear = 0, quadratic = 0;
};

ViscosityStrength strengthOf(const SolverSettings& s) {
  if (const MonaghanSettings* m = s.monaghan()) return {m->alpha, m->beta};
  if (const TensorSettings* t = s.tensor()) return {t->alpha1, t->alpha2};
  ViscosityStrength strength;
  if (s.bulk()) strength.linear = 2 * s.bulk()->alpha;
  if (s.neumannRichtmyer()) strength.quadratic = 2 * s.neumannRichtmyer()->alpha;
  return strength;
}

}  // namespace

template <int Dim>
void Gas<Dim>::setLengths(ParticleSet<Dim>& particles, double h) const {
  const auto lengths = particles[field::smoothingLength];
  const auto mass = particles[field::mass], density = particles[field::density];
  const double eta = settings_.smoothingLength;
  forEachIndex(particles.size(), [&](std::size_t i) {
    lengths[i] = settings_.lengthsFollow() ? eta * std::pow(mass[i] / density[i], 1.0 / Dim) : h;
  });
}

template <int Dim>
void Gas<Dim>::setWallConstants(ParticleSet<Dim>& particles) const {
  const std::size_t nFluid = particles.nFluid();
  std::ranges::copy(particles[field::density].subspan(nFluid),
                    particles[field::omegaDensity].begin() + static_cast<std::ptrdiff_t>(nFluid));
  if (particles.has(field::viscousPressure))
    std::ranges::fill(particles[field::viscousPressure], 0.0);
  if (particles.has(field::viscosityLimiter))
    std::ranges::fill(particles[field::viscosityLimiter], 1.0);
}

template <int Dim>
void Gas<Dim>::updatePressure(ParticleSet<Dim>& particles) const {
  const double gamma = settings_.adiabaticIndex;
  const auto pressure = particles[field::pressure], soundSpeed = particles[field::soundSpeed];
  const auto density = std::as_const(particles)[field::density];
  const auto energy = std::as_const(particles)[field::internalEnergy];
  const std::size_t nPressing =
      settings_.wallPressure == "zero" ? particles.nFluid() : particles.size();
  forEachIndex(particles.size(), [&](std::size_t i) {
    pressure[i] = i < nPressing ? (gamma - 1) * density[i] * energy[i] : 0;
    soundSpeed[i] = std::sqrt(gamma * (gamma - 1) * energy[i]);
  });
}

template <int Dim>
void Gas<Dim>::updateViscosity(Engine<Dim>& engine, const StepPasses<Dim>& passes,
                               ParticleSet<Dim>& particles) const {
  if (!passes.convergence) return;
  engine.run(passes.convergence, particles);
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const auto density = std::as_const(particles)[field::density];
  const auto omegaDensity = std::as_const(particles)[field::omegaDensity];
  const auto h = std::as_const(particles)[field::smoothingLength];
  const auto c = std::as_const(particles)[field::soundSpeed];
  std::span<double> q, limiter;
  if (particles.has(field::viscousPressure)) q = particles[field::viscousPressure];
  if (particles.has(field::viscosityLimiter)) limiter = particles[field::viscosityLimiter];
  const double bulk = settings_.bulk() ? settings_.bulk()->alpha : 0;
  const double neumannRichtmyer =
      settings_.neumannRichtmyer() ? settings_.neumannRichtmyer()->alpha : 0;
  engine.forEachSum(
      Group::fluids,
      [&](std::size_t i, double rate, const Vec<Dim>& curlSum) {
        const double div = -rate / omegaDensity[i], curl = norm(curlSum) / omegaDensity[i];
        const double convergence = h[i] * std::max(0.0, -div);
        if (!q.empty())
          q[i] = density[i] * convergence * (bulk * c[i] + neumannRichtmyer * convergence);
        if (!limiter.empty()) {
          const double noise = 1e-4 * c[i] / h[i];
          limiter[i] = std::abs(div) / (std::abs(div) + curl + noise);
        }
      },
      field::densityRate, field::velocityCurl);
}

template <int Dim>
double Gas<Dim>::takeRates(Engine<Dim>& engine, ParticleSet<Dim>& particles) const {
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const auto divergence = particles[field::velocityDivergence];
  const auto omegaDensity = std::as_const(particles)[field::omegaDensity];
  const auto h = std::as_const(particles)[field::smoothingLength];
  const auto c = std::as_const(particles)[field::soundSpeed];
  const auto mass = std::as_const(particles)[field::mass];
  const ViscosityStrength strength = strengthOf(settings_);
  const double ofHeat = settings_.conductivity ? settings_.conductivity->alpha : 0;
  const double ofSound = std::max(1 + 0.6 * strength.linear, ofHeat);
  const double ofDivergence = 1 + 0.6 * strength.quadratic;
  const Vec<Dim> gravity = gravityOf<Dim>(settings_);
  double largestSignal = 0, largestForce = 0;
  engine.withSums(field::densityRate, [&](const auto& rates) {
    engine.withSums(field::force, [&](const auto& forces) {
      const std::size_t nClusters = rates.nClusters(false);
#pragma omp parallel for schedule(static) reduction(max : largestSignal, largestForce)
      for (std::size_t k = 0; k < nClusters; ++k)
        rates.forEachPlace(k, [&](std::size_t i, std::size_t place) {
          const double div = -rates.at(k, place) / omegaDensity[i];
          divergence[i] = div;
          largestSignal =
              std::max(largestSignal, ofSound * c[i] / h[i] + ofDivergence * std::abs(div));
          const Vec<Dim> acceleration = (1 / mass[i]) * forces.at(k, place) + gravity;
          largestForce = std::max(largestForce, normSquared(acceleration) / power<2>(h[i]));
        });
    });
  });
  return std::max(largestSignal, std::sqrt(std::sqrt(largestForce)));
}

/// de_i/dt = power/m, and in the grad_h form the work of PressureGradH beside it,
/// p_i/(Omega_i rho_i^2) sum_j m_j v_ij . grad_i W_ij(h_i).
template <int Dim>
void Gas<Dim>::takeHeating(Engine<Dim>& engine, ParticleSet<Dim>& particles) const {
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const auto heating = particles[field::internalEnergyRate];
  const auto mass = std::as_const(particles)[field::mass];
  const auto density = std::as_const(particles)[field::density];
  const auto omegaDensity = std::as_const(particles)[field::omegaDensity];
  const auto pressure = std::as_const(particles)[field::pressure];
  std::span<const double> viscous;
  if (particles.has(field::viscousPressure))
    viscous = std::as_const(particles)[field::viscousPressure];
  const bool isGradH = settings_.hasForm("grad_h");
  engine.forEachSum(
      Group::fluids,
      [&](std::size_t i, double power, double rate) {
        const double p = pressure[i] + (viscous.empty() ? 0 : viscous[i]);
        heating[i] = power / mass[i] + (isGradH ? p / (density[i] * omegaDensity[i]) * rate : 0);
      },
      field::power, field::densityRate);
}

template <int Dim>
double largestSignalSpeed(const ParticleSet<Dim>& particles, const SolverSettings& settings,
                          double soundSpeed) {
  if (!settings.isIdealGas() || !particles.has(field::internalEnergy)) return soundSpeed;
  const double gamma = settings.adiabaticIndex;
  double squared = 0;
  for (std::size_t i = 0; i < particles.nFluid(); ++i)
    squared = std::max({squared, normSquared(particles[field::velocity][i]),
                        gamma * (gamma - 1) * particles[field::internalEnergy][i]});
  return std::sqrt(squared);
}

template class Gas<1>;
template class Gas<2>;
template class Gas<3>;
template double largestSignalSpeed(const ParticleSet<1>&, const SolverSettings&, double);
template double largestSignalSpeed(const ParticleSet<2>&, const SolverSettings&, double);
template double largestSignalSpeed(const ParticleSet<3>&, const SolverSettings&, double);

}  // namespace plenum
