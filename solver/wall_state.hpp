// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"
#include "particles/case_settings.hpp"
#include "solver/equation_of_state.hpp"

#include <span>

namespace plenum {

/// How walls move, besides their velocities; lists of length nWalls(), empty if all stand still.
template <int Dim>
struct WallMovement {
  std::span<const Vec<Dim>> accelerations = {};   ///< [m/s^2]
  std::span<const Vec<Dim>> towardsSurface = {};  ///< surface velocities less their own [m/s]
};

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
  /// With `atWalls` and field::slipVelocity also the velocities 2 v_s - v_f that a sticking fluid
  /// feels, (23); v_s is that of the surface before the particle, which of a wall that turns is not
  /// the particle's own.
  void update(Engine<Dim>& engine, const PairPass<Dim>& atWalls, ParticleSet<Dim>& particles,
              const WallMovement<Dim>& movement) const;

 private:
  void setPressures(ParticleSet<Dim>& particles) const;
  void setSlip(const Engine<Dim>& engine, ParticleSet<Dim>& particles,
               std::span<const Vec<Dim>> towardsSurface) const;
  void extrapolate(const Engine<Dim>& engine, ParticleSet<Dim>& particles,
                   std::span<const Vec<Dim>> accelerations) const;

  /// A wall particle with less fluid around it feels none.
  static constexpr double leastKernelSum = 1e-6;

  SolverSettings settings_;
  MaterialTable states_;
  Vec<Dim> gravity_;
};

extern template class WallState<1>;
extern template class WallState<2>;
extern template class WallState<3>;

}  // namespace plenum
