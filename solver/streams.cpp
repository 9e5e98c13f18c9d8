// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/streams.hpp"

#include "engine/ordered_sum.hpp"
#include "particles/errors.hpp"
#include "particles/parallel.hpp"
#include "solver/particle_energy.hpp"
#include "solver/smoothing_lengths.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>
#include <ranges>

namespace plenum {

template <int Dim>
typename Streams<Dim>::Rates& Streams<Dim>::Rates::operator+=(const Rates& other) {
  power += other.power;
  force += other.force;
  return *this;
}

template <int Dim>
void Streams<Dim>::begin(const ParticleSet<Dim>& particles) {
  nextId_ = std::ranges::max(particles[field::id]) + 1;
}

template <int Dim>
void Streams<Dim>::settleBuffers(const SolverSettings& settings,
                                 const typename Engine<Dim>::Options& options,
                                 const StepPasses<Dim>& passes, Scene<Dim>& scene) const {
  ParticleSet<Dim>& particles = scene.particles;
  const std::size_t nFluid = particles.nFluid();
  SolverSettings withoutPlanes = settings;
  withoutPlanes.inflows.clear();
  withoutPlanes.outflows.clear();
  const SmoothingLengths<Dim> lengths(withoutPlanes);
  for (const StreamPlane<Dim>& plane : planes_) {
    if (!plane.isInflow) continue;
    std::map<std::uint64_t, std::uint32_t> indexOf;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < nFluid; ++i)
      if (plane.depth(particles[field::position][i]) > 0) {
        indices.push_back(i);
        indexOf[particles[field::id][i]] = i;
      }
    Box<Dim> domain = scene.info.domain;
    domain.lower[plane.axis] = std::min(plane.at, plane.end());
    domain.upper[plane.axis] = std::max(plane.at, plane.end());
    domain.periodic[static_cast<std::size_t>(plane.axis)] = true;
    ParticleSet<Dim> buffer = particles.fluidsOf(indices);
    Engine<Dim> engine(domain, options);
    engine.update(buffer);
    lengths.begin(engine, passes, buffer);
    for (std::size_t k = 0; k < buffer.size(); ++k) {
      const std::uint32_t i = indexOf.at(buffer[field::id][k]);
      for (const auto f : {field::smoothingLength, field::density}) particles[f][i] = buffer[f][k];
    }
  }
}

template <int Dim>
void Streams<Dim>::beforeMove(const ParticleSet<Dim>& particles) {
  const auto position = particles[field::position];
  wasInBuffer_.resize(particles.nFluid());
  forEachIndex(wasInBuffer_.size(), [&](std::size_t i) {
    const StreamPlane<Dim>* plane = planes_.beyond(position[i]);
    wasInBuffer_[i] = plane != nullptr && plane->isInflow;
  });
}

template <int Dim>
typename Streams<Dim>::Fate Streams<Dim>::fateOf(const ParticleSet<Dim>& particles,
                                                 std::size_t i) const {
  const Vec<Dim>& x = particles[field::position][i];
  for (const StreamPlane<Dim>& plane : planes_) {
    const double depth = plane.depth(x);
    if (plane.isInflow) {
      if (depth > 0) return wasInBuffer_[i] ? Fate::stays : Fate::comesBack;
    } else if (depth > 0) {
      return depth > plane.length ? Fate::leaves : Fate::stays;
    } else {
      const double h =
          particles.has(field::smoothingLength) ? particles[field::smoothingLength][i] : h_;
      if (depth > -h && plane.along(particles[field::velocity][i]) < 0) return Fate::comesBack;
    }
  }
  return wasInBuffer_[i] ? Fate::comesIn : Fate::stays;
}

template <int Dim>
void Streams<Dim>::afterMove(Engine<Dim>& engine, ParticleSet<Dim>& particles, double dt) {
  const std::size_t n = particles.nFluid();
  std::size_t bad = n, nChanged = 0;
#pragma omp parallel for schedule(static) reduction(min : bad) reduction(+ : nChanged)
  for (std::size_t i = 0; i < n; ++i) {
    const Fate fate = fateOf(particles, i);
    if (fate == Fate::comesBack) bad = std::min(bad, i);
    if (fate != Fate::stays) ++nChanged;
  }
  if (bad < n) failBackwards(particles, bad);
  if (nChanged == 0) return;
  std::vector<std::uint32_t> removed, copied;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Fate fate = fateOf(particles, i);
    if (fate != Fate::stays) (fate == Fate::leaves ? removed : copied).push_back(i);
  }
  count(particles, removed, -1, dt);
  particles.exchangeFluids(removed, copied);
  const std::size_t firstCopy = particles.nFluid() - copied.size();
  sendBack(particles, firstCopy);
  count(particles, std::views::iota(firstCopy, particles.nFluid()), 1, dt);
  engine.forget();
}

/// Makes the fluids from `first` on, copies of those that came in, followers of theirs in the
/// buffer.
template <int Dim>
void Streams<Dim>::sendBack(ParticleSet<Dim>& particles, std::size_t first) {
  for (std::size_t i = first; i < particles.nFluid(); ++i) {
    Vec<Dim>& x = particles[field::position][i];
    particles[field::id][i] = nextId_++;
    const StreamPlane<Dim>* nearest = nullptr;  // inflow: the one that it has just come through
    for (const StreamPlane<Dim>& plane : planes_)
      if (plane.isInflow && (nearest == nullptr || plane.depth(x) > nearest->depth(x)))
        nearest = &plane;
    x[nearest->axis] += nearest->outward * nearest->length;
  }
}

/// Adds these particles to what came in (sign 1) or went out (-1). The powers of a step act in its
/// halves, those of what was there before and of what is there after, so it counts what they have
/// in gravity in its middle.
template <int Dim>
template <class Indices>
void Streams<Dim>::count(const ParticleSet<Dim>& particles, const Indices& indices, double sign,
                         double dt) {
  const ParticleEnergies<Dim> energies(particles, states_, gravity_);
  double& total = sign > 0 ? balance_.massIn : balance_.massOut;
  for (const std::size_t i : indices) {
    const double mass = particles[field::mass][i];
    total += mass;
    const Vec<Dim>& v = particles[field::velocity][i];
    balance_.energyIn += sign * (energies(i).sum() + mass * dot(gravity_, v) * dt / 2);
    balance_.momentumIn += sign * mass * v;
  }
}

template <int Dim>
void Streams<Dim>::failBackwards(const ParticleSet<Dim>& particles, std::size_t i) const {
  const Vec<Dim>& x = particles[field::position][i];
  const StreamPlane<Dim>* nearest = nullptr;
  for (const StreamPlane<Dim>& plane : planes_)
    if (nearest == nullptr || std::abs(plane.depth(x)) < std::abs(nearest->depth(x)))
      nearest = &plane;
  const char* way = nearest->isInflow ? "out through the inflow" : "from the outflow";
  const double at = nearest->at, speed = -nearest->along(particles[field::velocity][i]);
  throw RunError(fmt::format(
      "particle {} at ({:.4g}): flows back {} at {} = {:g} m with {:.4g} "
      "m/s: what is beyond a plane does not answer to the scene; move the plane further away, make "
      "the stream faster or the run shorter",
      particles[field::id][i], fmt::join(x.components, ", "), way, "xyz"[nearest->axis], at,
      speed));
}

template <int Dim>
void Streams<Dim>::hold(ParticleSet<Dim>& particles) {
  const auto position = std::as_const(particles)[field::position];
  const auto velocity = std::as_const(particles)[field::velocity];
  const auto mass = std::as_const(particles)[field::mass];
  const auto density = std::as_const(particles)[field::density];
  const auto pressure = std::as_const(particles)[field::pressure];
  const auto acceleration = particles[field::acceleration];
  std::span<double> heating;
  std::span<const double> divergence;
  if (particles.has(field::internalEnergyRate))
    heating = particles[field::internalEnergyRate];
  else if (particles.has(field::velocityDivergence))
    divergence = std::as_const(particles)[field::velocityDivergence];
  held_ = orderedSum<Rates>(particles.nFluid(), [&](std::size_t i) {
    Rates lost;
    if (planes_.beyond(position[i]) == nullptr) return lost;
    lost.force = mass[i] * acceleration[i];
    lost.power = dot(lost.force, velocity[i]);
    acceleration[i] = {};
    if (!heating.empty()) {
      lost.power += mass[i] * heating[i];
      heating[i] = 0;
    } else if (!divergence.empty() && planes_.isDeep(position[i])) {
      // Its density stays, and with it the energy that the pressure would store there.
      lost.power -= mass[i] * pressure[i] / density[i] * divergence[i];
    }
    return lost;
  });
}

template <int Dim>
void Streams<Dim>::act(double duration) {
  balance_.energyIn -= duration * held_.power;
  balance_.momentumIn -= duration * held_.force;
}

template <int Dim>
std::vector<std::pair<std::string, double>> Streams<Dim>::progress() const {
  std::vector<std::pair<std::string, double>> figures{
      {"streams_next_id", static_cast<double>(nextId_)},
      {"streams_mass_in", balance_.massIn},
      {"streams_mass_out", balance_.massOut},
      {"streams_energy_in", balance_.energyIn},
      {"streams_held_power", held_.power}};
  for (int a = 0; a < Dim; ++a) {
    figures.emplace_back(fmt::format("streams_momentum_in_{}", "xyz"[a]), balance_.momentumIn[a]);
    figures.emplace_back(fmt::format("streams_held_force_{}", "xyz"[a]), held_.force[a]);
  }
  return figures;
}

template <int Dim>
void Streams<Dim>::restore(const std::vector<std::pair<std::string, double>>& progress) {
  // Written by `progress` above, in its order.
  const auto mine = this->progress();
  const auto found = std::ranges::search(
      progress, mine, [](const auto& a, const auto& b) { return a.first == b.first; });
  if (found.empty())
    throw InputError(
        "the file says that a run paused here, but not what came in through its inflows; start a "
        "new one with `plenum-sph run`");
  auto value = found.begin();
  nextId_ = static_cast<std::uint64_t>((value++)->second);
  for (double* figure : {&balance_.massIn, &balance_.massOut, &balance_.energyIn, &held_.power})
    *figure = (value++)->second;
  for (int a = 0; a < Dim; ++a) {
    balance_.momentumIn[a] = (value++)->second;
    held_.force[a] = (value++)->second;
  }
}

template class Streams<1>;
template class Streams<2>;
template class Streams<3>;

}  // namespace plenum
