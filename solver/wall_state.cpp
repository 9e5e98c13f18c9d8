// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/wall_state.hpp"

#include <algorithm>

namespace plenum {

template <int Dim>
void WallState<Dim>::update(Engine<Dim>& engine, const PairPass<Dim>& atWalls,
                            ParticleSet<Dim>& particles, const WallMovement<Dim>& movement) const {
  if (particles.nWalls() == 0) return;
  if (atWalls) engine.run(atWalls, particles);
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  if (settings_.wallsExtrapolate())
    extrapolate(engine, particles, movement.accelerations);
  else
    setPressures(particles);
  if (particles.has(field::slipVelocity)) setSlip(engine, particles, movement.towardsSurface);
}

template <int Dim>
void WallState<Dim>::extrapolate(const Engine<Dim>& engine, ParticleSet<Dim>& particles,
                                 std::span<const Vec<Dim>> accelerations) const {
  const std::size_t nFluid = particles.nFluid();
  const auto pressure = particles[field::pressure];
  const auto density = particles[field::density];
  const auto wallOf = std::as_const(particles)[field::wall];
  engine.forEachSum(
      Group::walls,
      [&](std::size_t i, double kernelSum, double pressureSum, const Vec<Dim>& massMoment) {
        const Tait& state = states_.of(wallOf, i - nFluid);
        if (!(kernelSum > leastKernelSum)) {  // nobody feels it
          pressure[i] = 0;
          density[i] = state.referenceDensity;
          return;
        }
        const Vec<Dim> fall =
            accelerations.empty() ? gravity_ : gravity_ - accelerations[i - nFluid];
        pressure[i] = std::max(0.0, (pressureSum + dot(fall, massMoment)) / kernelSum);
        density[i] = state.density(pressure[i]);
      },
      field::kernelSum, field::pressure, field::massMoment);
}

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
void WallState<Dim>::setSlip(const Engine<Dim>& engine, ParticleSet<Dim>& particles,
                             std::span<const Vec<Dim>> towardsSurface) const {
  const std::size_t nFluid = particles.nFluid();
  const auto slip = particles[field::slipVelocity];
  const auto velocity = std::as_const(particles)[field::velocity];
  engine.forEachSum(
      Group::walls,
      [&](std::size_t i, double kernelSum, const Vec<Dim>& sum) {
        Vec<Dim> surface = velocity[i];
        if (!towardsSurface.empty()) surface += towardsSurface[i - nFluid];
        slip[i - nFluid] =
            kernelSum > leastKernelSum ? 2 * surface - (1 / kernelSum) * sum : velocity[i];
      },
      field::kernelSum, field::velocity);
}

template class WallState<1>;
template class WallState<2>;
template class WallState<3>;

}  // namespace plenum
