// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "solver/equation_of_state.hpp"

#include <span>

namespace plenum {

/// The energy of a fluid particle by its kinds [J].
struct ParticleEnergy {
  double kinetic = 0;
  double potential = 0;    ///< in gravity, zero at the origin
  double compression = 0;  ///< of the equation of state, zero at rho0
  double internal = 0;     ///< of an ideal gas, instead

  double sum() const { return kinetic + potential + compression + internal; }
};

/// The energies of fluid particles; valid as long as the set keeps its arrays.
template <int Dim>
class ParticleEnergies {
 public:
  ParticleEnergies(const ParticleSet<Dim>& particles, const MaterialTable& states,
                   const Vec<Dim>& gravity)
      : states_(states),
        gravity_(gravity),
        position_(particles[field::position]),
        velocity_(particles[field::velocity]),
        mass_(particles[field::mass]),
        density_(particles[field::density]) {
    if (particles.has(field::internalEnergy)) internal_ = particles[field::internalEnergy];
    if (particles.has(field::material)) material_ = particles[field::material];
  }

  ParticleEnergy operator()(std::size_t i) const {
    ParticleEnergy energy;
    energy.kinetic = 0.5 * mass_[i] * normSquared(velocity_[i]);
    energy.potential = -mass_[i] * dot(gravity_, position_[i]);
    if (internal_.empty())
      energy.compression = mass_[i] * states_.of(material_, i).compressionEnergy(density_[i]);
    else
      energy.internal = mass_[i] * internal_[i];
    return energy;
  }

 private:
  const MaterialTable& states_;
  Vec<Dim> gravity_;
  std::span<const Vec<Dim>> position_, velocity_;
  std::span<const double> mass_, density_, internal_;  // internal_: empty but in an ideal gas
  std::span<const std::int32_t> material_;             // empty where there is but one
};

}  // namespace plenum
