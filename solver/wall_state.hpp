// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"
#include "particles/case_settings.hpp"
#include "solver/equation_of_state.hpp"
#include "solver/wall_motion.hpp"

#include <vector>

namespace plenum {

/// What the fluid feels of the walls: their pressure, their density, and the velocity behind their
/// surface.
template <int Dim>
class WallState {
 public:
  /// `states` has a row a wall.
  WallState(const SolverSettings& settings, MaterialTable states, const Vec<Dim>& gravity)
      : settings_(settings), states_(std::move(states)), gravity_(gravity) {}

  /// Sets the pressures of the walls, as SolverSettings::wallPressure wants them; extrapolated ones
  /// by `atWalls`, with p_w = (sum V p W + (g - a_w) . sum m r_wf W)/sum V W, Adami et al. 2012
  /// (27), never below zero: a wall does not pull. Their density follows by the equation of state.
  /// With `atWalls` and field::slipVelocity also the velocities 2 v_w - v_f that a sticking fluid
  /// feels, (23). `wallAcceleration(i)` [m/s^2] is that of wall particle i.
  template <class Acceleration>
  void update(Engine<Dim>& engine, const PairPass<Dim>& atWalls, ParticleSet<Dim>& particles,
              Acceleration&& wallAcceleration) {
    if (particles.nWalls() == 0) return;
    if (atWalls) engine.run(atWalls, particles);
    const auto integrating = engine.stopwatch().lap(Part::integrate);
    if (settings_.wallsExtrapolate()) {
      extrapolate(engine, particles, wallAcceleration);
    } else {
      setPressures(particles);
    }
    if (particles.has(field::slipVelocity)) setSlip(engine, particles);
  }

 private:
  void setPressures(ParticleSet<Dim>& particles) const;
  void setSlip(const Engine<Dim>& engine, ParticleSet<Dim>& particles) const;
  template <class Acceleration>
  void extrapolate(const Engine<Dim>& engine, ParticleSet<Dim>& particles,
                   Acceleration&& wallAcceleration) const;

  /// A wall particle with less fluid around it feels none.
  static constexpr double leastKernelSum = 1e-6;

  SolverSettings settings_;
  MaterialTable states_;
  Vec<Dim> gravity_;
};

template <int Dim>
template <class Acceleration>
void WallState<Dim>::extrapolate(const Engine<Dim>& engine, ParticleSet<Dim>& particles,
                                 Acceleration&& wallAcceleration) const {
  const std::size_t nFluid = particles.nFluid();
  const auto pressure = particles[field::pressure];
  const auto density = particles[field::density];
  const auto wallOf = std::as_const(particles)[field::wall];
  engine.forEachSum(
      Group::walls,
      [&](std::size_t i, double kernelSum, double pressureSum, const Vec<Dim>& massMoment) {
        const Tait& state = states_.of(wallOf, i - nFluid);
        double p = 0;
        if (kernelSum > leastKernelSum)
          p = std::max(0.0,
                       (pressureSum + dot(gravity_ - wallAcceleration(i), massMoment)) / kernelSum);
        pressure[i] = p;
        density[i] = state.density(p);
      },
      field::kernelSum, field::pressure, field::massMoment);
}

extern template class WallState<1>;
extern template class WallState<2>;
extern template class WallState<3>;

}  // namespace plenum
