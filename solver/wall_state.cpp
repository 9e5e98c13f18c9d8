// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/wall_state.hpp"

#include <algorithm>

namespace plenum {

template <int Dim>
void WallState<Dim>::setPressures(ParticleSet<Dim>& particles) const {
  const std::size_t nFluid = particles.nFluid();
  const auto pressure = particles[field::pressure].subspan(nFluid);
  if (settings_.wallPressure == "zero")
    std::ranges::fill(pressure, 0.0);
  else  // "initial": of the density that they keep
    states_.pressures(std::as_const(particles)[field::density].subspan(nFluid),
                      std::as_const(particles)[field::wall], pressure);
}

template <int Dim>
void WallState<Dim>::setSlip(const Engine<Dim>& engine, ParticleSet<Dim>& particles) const {
  const std::size_t nFluid = particles.nFluid();
  const auto slip = particles[field::slipVelocity];
  const auto velocity = std::as_const(particles)[field::velocity];
  engine.forEachSum(
      Group::walls,
      [&](std::size_t i, double kernelSum, const Vec<Dim>& sum) {
        slip[i - nFluid] =
            kernelSum > leastKernelSum ? 2 * velocity[i] - (1 / kernelSum) * sum : velocity[i];
      },
      field::kernelSum, field::velocity);
}

template class WallState<1>;
template class WallState<2>;
template class WallState<3>;

}  // namespace plenum
