// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/interpolation.hpp"

namespace plenum {

template <int Dim>
Interpolation<Dim>::Interpolation(const Observed<Dim>& state)
    : state_(state),
      profile_{state.kernel},
      atZero_(profile_.sigma(Dim) * power<Dim>(1 / state.smoothingLength)),
      search_(state.particles[field::position], state.info.domain, 2 * state.smoothingLength) {}

template <int Dim>
typename Interpolation<Dim>::Sums Interpolation<Dim>::at(const Vec<Dim>& x,
                                                         const FluidChoice& counted) const {
  const ParticleSet<Dim>& particles = state_.particles;
  const auto mass = particles[field::mass];
  const auto density = particles[field::density];
  Sums sums;
  search_.around(x, [&](std::uint32_t j, const Vec<Dim>&, double distanceSquared) {
    const double R = std::sqrt(distanceSquared) / state_.smoothingLength;
    const double weight = mass[j] / density[j] * atZero_ * profile_.f(R);
    if (j >= particles.nFluid()) {
      sums.walls += weight;
      return;
    }
    if (!counted.has(particles, j)) return;
    sums.fluid += weight;
    sums.pressure += weight * particles[field::pressure][j];
    sums.velocity += weight * particles[field::velocity][j];
  });
  return sums;
}

template <int Dim>
double Interpolation<Dim>::fluidFraction(const Vec<Dim>& x, const FluidChoice& counted) const {
  constexpr double leastRoom = 0.1;  // a corner of three walls leaves an eighth
  const Sums sums = at(x, counted);
  const double room = 1 - sums.walls;
  return room > leastRoom ? sums.fluid / room : 0;
}

template class Interpolation<1>;
template class Interpolation<2>;
template class Interpolation<3>;

}  // namespace plenum
