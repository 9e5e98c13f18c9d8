// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"
#include "particles/particle_set.hpp"

#include <algorithm>
#include <random>
#include <vector>

namespace plenum::test {

/// A unit box, all axes periodic or all open.
template <int Dim>
Box<Dim> unitBox(bool periodic) {
  Box<Dim> box;
  box.upper = Vec<Dim>::filled(1);
  box.periodic.fill(periodic);
  return box;
}

/// Particles at random places in a box with random velocities, masses, densities and pressures, so
/// that no symmetry hides a mistake. Ids: walls first, as plenum-ic numbers them.
template <int Dim>
ParticleSet<Dim> randomParticles(const Box<Dim>& box, std::size_t nFluid, std::size_t nWalls,
                                 unsigned seed = 1) {
  FieldSet fields{field::position, field::velocity, field::mass,
                  field::density,  field::pressure, field::id};
  if (nWalls > 0) fields |= {field::wall, field::normal, field::wallDistance};
  ParticleSet<Dim> particles(fields, nFluid, nWalls);
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    for (int a = 0; a < Dim; ++a) {
      particles[field::position][i][a] =
          box.lower[a] + uniform(generator) * (box.upper[a] - box.lower[a]);
      particles[field::velocity][i][a] = uniform(generator) - 0.5;
    }
    particles[field::mass][i] = 0.5 + uniform(generator);
    particles[field::density][i] = 0.5 + uniform(generator);
    particles[field::pressure][i] = uniform(generator) - 0.3;
    particles[field::id][i] = i < nFluid ? nWalls + 1 + i : 1 + i - nFluid;
  }
  return particles;
}

/// Index of each particle by ascending id: the order in which states are compared.
template <int Dim>
std::vector<std::size_t> byId(const ParticleSet<Dim>& particles) {
  std::vector<std::size_t> order(particles.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto ids = particles[field::id];
  std::ranges::sort(order, {}, [&](std::size_t k) { return ids[k]; });
  return order;
}

}  // namespace plenum::test
