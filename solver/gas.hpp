// SPDX-License-Identifier: GPL-3.0-or-later
//
// What particles with smoothing lengths, and with an ideal gas energies, of their own have beside
// what a liquid has.
#pragma once

#include "engine/engine.hpp"
#include "particles/case_settings.hpp"
#include "solver/pair_pass.hpp"
#include "solver/smoothing_lengths.hpp"

namespace plenum {

/// A gas between the passes of a step. Fields that a scene has not are left alone.
template <int Dim>
class Gas {
 public:
  explicit Gas(const SolverSettings& settings) : settings_(settings), lengths_(settings) {}

  /// Smoothing lengths to begin with; `h` [m] is that of all particles where they are not adaptive.
  void setLengths(ParticleSet<Dim>& particles, double h) const;
  /// What walls have all the time.
  void setWallConstants(ParticleSet<Dim>& particles) const;

  const SmoothingLengths<Dim>& lengths() const { return lengths_; }

  /// Ideal gas: pressure and speed of sound of all particles, p = (gamma - 1) rho e,
  /// c^2 = gamma (gamma - 1) e, [N]. With walls of wall_pressure "zero", p = 0 there.
  void updatePressure(ParticleSet<Dim>& particles) const;

  /// Where particles converge: field::viscousPressure, [A] (4.8) and (4.9), and
  /// field::viscosityLimiter, Balsara 1995, doi 10.1016/S0021-9991(95)90221-X.
  void updateViscosity(Engine<Dim>& engine, const StepPasses<Dim>& passes,
                       ParticleSet<Dim>& particles) const;

  /// To be called when forces have been summed. Sets field::velocityDivergence and returns the
  /// largest rate at which a particle changes [1/s]:
  /// (c (1 + 0.6 alpha) + (1 + 0.6 beta) h |div v|)/h, after Monaghan 1992, and sqrt(|a|/h). A
  /// conductivity counts where it is more than that: its signals are no faster than alpha c.
  double takeRates(Engine<Dim>& engine, ParticleSet<Dim>& particles) const;

  /// Ideal gas: field::internalEnergyRate by the forces that were summed.
  void takeHeating(Engine<Dim>& engine, ParticleSet<Dim>& particles) const;

 private:
  SolverSettings settings_;
  SmoothingLengths<Dim> lengths_;
};

/// The largest speed of sound or of a particle in a scene [m/s].
template <int Dim>
double largestSignalSpeed(const ParticleSet<Dim>& particles, const SolverSettings& settings,
                          double soundSpeed);

}  // namespace plenum
