// SPDX-License-Identifier: GPL-3.0-or-later
//
// Smoothing lengths that follow the density of a gas, and the densities that go with them.
#pragma once

#include "engine/engine.hpp"
#include "particles/case_settings.hpp"
#include "solver/pair_pass.hpp"
#include "solver/stream_planes.hpp"

namespace plenum {

/// Summed densities and the smoothing lengths of the fluids; those of walls, and of fluid deep
/// beyond the plane of a stream, stay as they are.
///
/// grad_h: h_i = eta (m_i/rho_i(h_i))^(1/d), found by Newton's method from a prediction. Springel &
/// Hernquist 2002, doi 10.1046/j.1365-8711.2002.05445.x; Price 2012, doi 10.1016/j.jcp.2010.12.011.
/// mean_density: h_i = eta (m_i/rho_mean,i)^(1/d), rho_mean = <rho^2>/<rho>, [A].
template <int Dim>
class SmoothingLengths {
 public:
  explicit SmoothingLengths(const SolverSettings& settings);

  /// Lengths and densities before the first step.
  void begin(Engine<Dim>& engine, const StepPasses<Dim>& passes, ParticleSet<Dim>& particles) const;

  /// Lengths and densities at the present positions: field::smoothingLength, density and
  /// omegaDensity. Returns how often densities were summed. Throws RunError for particles whose
  /// lengths do not converge.
  int update(Engine<Dim>& engine, const StepPasses<Dim>& passes, ParticleSet<Dim>& particles) const;

  /// What grad_h will find after dt [s], to first order: h <- h exp(dt div v/d), by
  /// field::velocityDivergence.
  void predict(Engine<Dim>& engine, ParticleSet<Dim>& particles, double dt) const;

 private:
  struct Correction {
    double error = 0;   ///< of a density that the next length leaves, as a part of it
    double growth = 1;  ///< largest factor of a length
  };

  void sumDensities(Engine<Dim>& engine, const PairPass<Dim>& density,
                    ParticleSet<Dim>& particles) const;
  Correction correct(ParticleSet<Dim>& particles) const;
  int updateFromOwnDensity(Engine<Dim>& engine, const StepPasses<Dim>& passes,
                           ParticleSet<Dim>& particles) const;
  void followMeanDensity(Engine<Dim>& engine, const StepPasses<Dim>& passes,
                         ParticleSet<Dim>& particles, double changeLimit) const;
  double updateFromMeanDensity(Engine<Dim>& engine, const PairPass<Dim>& densityMoment,
                               ParticleSet<Dim>& particles, double changeLimit) const;
  [[noreturn]] void failToConverge(const ParticleSet<Dim>& particles) const;

  AdaptiveSettings settings_;
  bool isAdaptive_, isGradH_;
  double eta_;       ///< h/(m/rho)^(1/d)
  double selfTerm_;  ///< taken from densities, in m h^-d
  StreamPlanes<Dim> planes_;
};

}  // namespace plenum
