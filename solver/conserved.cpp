// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/conserved.hpp"

#include "engine/ordered_sum.hpp"
#include "solver/particle_energy.hpp"

namespace plenum {

Conserved& Conserved::operator+=(const Conserved& other) {
  mass += other.mass;
  kineticEnergy += other.kineticEnergy;
  potentialEnergy += other.potentialEnergy;
  compressionEnergy += other.compressionEnergy;
  internalEnergy += other.internalEnergy;
  for (std::size_t a = 0; a < 3; ++a) {
    momentum[a] += other.momentum[a];
    angularMomentum[a] += other.angularMomentum[a];
  }
  return *this;
}

template <int Dim>
Conserved measureConserved(const Simulation<Dim>& simulation) {
  const ParticleSet<Dim>& particles = simulation.particles();
  const auto position = particles[field::position];
  const auto velocity = particles[field::velocity];
  const auto mass = particles[field::mass];
  const ParticleEnergies<Dim> energies(particles, simulation.materials(), simulation.gravity());

  return orderedSum<Conserved>(particles.nFluid(), [&](std::size_t i) {
    const double m = mass[i];
    const auto x = toThree(position[i]), v = toThree(velocity[i]);
    Conserved c;
    c.mass = m;
    const ParticleEnergy energy = energies(i);
    c.kineticEnergy = energy.kinetic;
    c.potentialEnergy = energy.potential;
    c.compressionEnergy = energy.compression;
    c.internalEnergy = energy.internal;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t b = (a + 1) % 3, d = (a + 2) % 3;
      c.momentum[a] = m * v[a];
      c.angularMomentum[a] = m * (x[b] * v[d] - x[d] * v[b]);
    }
    return c;
  });
}

template Conserved measureConserved<1>(const Simulation<1>&);
template Conserved measureConserved<2>(const Simulation<2>&);
template Conserved measureConserved<3>(const Simulation<3>&);

}  // namespace plenum
