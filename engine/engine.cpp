// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/engine.hpp"

#include "particles/errors.hpp"
#include "particles/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace plenum {

template <int Dim>
Engine<Dim>::Engine(const Box<Dim>& domain, const Options& options)
    : domain_(domain), options_(options), periodicity_(domain) {
  skin_ = options.skin * options.support;
  for (int a = 0; a < Dim; ++a) {
    if (!domain.isPeriodic(a)) continue;
    const double length = domain.upper[a] - domain.lower[a];
    // Each pair must have one nearest image only.
    if (length < 2 * options.support)
      throw InputError(
          fmt::format("periodic axis {}: length {:g} m is shorter than twice the kernel's support "
                      "{:g} m; use a "
                      "longer box, a smaller smoothing_length or a smaller spacing",
                      "xyz"[a], length, options.support));
    skin_ = std::min(skin_, 0.5 * length - options.support);
  }
}

template <int Dim>
bool Engine<Dim>::update(ParticleSet<Dim>& particles) {
  if (reference_.size() == particles.size() && nRebuilds_ > 0 && !movedTooFar(particles))
    return false;
  sort(particles);
  const auto positions = std::as_const(particles)[field::position];
  list_.build(positions, options_.wallsReceive ? particles.size() : particles.nFluid(),
              particles.nFluid(), fluidCells_, wallCells_, periodicity_, options_.support + skin_);
  reference_.assign(positions.begin(), positions.end());
  ++nRebuilds_;
  return true;
}

template <int Dim>
bool Engine<Dim>::movedTooFar(const ParticleSet<Dim>& particles) const {
  const auto positions = particles[field::position];
  const double limitSquared = 0.25 * skin_ * skin_;
  const std::size_t n = positions.size();
  int moved = 0;
#pragma omp parallel for schedule(static) reduction(| : moved) if (n >= worthThreads)
  for (std::size_t i = 0; i < n; ++i) {
    const Vec<Dim> path = periodicity_.nearestImage(positions[i] - reference_[i]);
    moved |= !(normSquared(path) <= limitSquared);
  }
  return moved != 0;
}

template <int Dim>
Box<Dim> Engine<Dim>::boundsOf(const ParticleSet<Dim>& particles) const {
  Box<Dim> box = Box<Dim>::nothing();
  for (const Vec<Dim>& x : particles[field::position]) box.extend(x);
  box.periodic = domain_.periodic;
  for (int a = 0; a < Dim; ++a)
    if (domain_.isPeriodic(a)) {
      box.lower[a] = domain_.lower[a];
      box.upper[a] = domain_.upper[a];
    }
  return box;
}

template <int Dim>
void Engine<Dim>::sort(ParticleSet<Dim>& particles) {
  const auto positions = particles[field::position];
  for (Vec<Dim>& x : positions) x = domain_.wrap(x);

  // A particle that flew far away must not cost memory: beyond a few cells a particle, the grid
  // covers the domain that the scene began with, and strays count to its edge cells.
  const std::size_t maxCells = 4 * particles.size() + 64;
  const double radius = options_.support + skin_;
  Box<Dim> box = boundsOf(particles);
  double wanted = 1;
  for (int a = 0; a < Dim; ++a) wanted *= std::max(1.0, (box.upper[a] - box.lower[a]) / radius);
  if (!(wanted <= static_cast<double>(maxCells))) box = domain_;

  const std::size_t nFluid = particles.nFluid();
  fluidCells_.reshape(box, radius, maxCells);
  fluidCells_.sort(positions.first(nFluid));
  wallCells_.reshape(box, radius, maxCells);
  wallCells_.sort(positions.subspan(nFluid));

  order_.resize(particles.size());
  std::ranges::copy(fluidCells_.order(), order_.begin());
  std::ranges::transform(
      wallCells_.order(), order_.begin() + static_cast<std::ptrdiff_t>(nFluid),
      [nFluid](std::uint32_t k) { return static_cast<std::uint32_t>(nFluid + k); });
  particles.permute(order_);
}

template <int Dim>
std::size_t Engine<Dim>::bytes() const {
  return list_.bytes() + reference_.capacity() * sizeof(Vec<Dim>) +
         3 * order_.capacity() * sizeof(std::uint32_t) +
         (fluidCells_.nCells() + wallCells_.nCells()) * sizeof(std::uint32_t);
}

template class Engine<1>;
template class Engine<2>;
template class Engine<3>;

}  // namespace plenum
