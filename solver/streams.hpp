// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"
#include "particles/scene.hpp"
#include "solver/equation_of_state.hpp"
#include "solver/pair_pass.hpp"
#include "solver/stream_planes.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace plenum {

/// What has come through the planes of a scene since the run began.
template <int Dim>
struct StreamBalance {
  double massIn = 0, massOut = 0;  ///< of particles that were added and taken out [kg]
  double energyIn = 0;  ///< what particles brought less what they took away, and work at planes [J]
  Vec<Dim> momentumIn{};  ///< likewise [kg m/s]
};

/// Fluid that comes in and leaves in the course of a run.
///
/// Fluid beyond a plane is held: it moves on with its velocity and energy, whatever its neighbours
/// do. Beyond an inflow it is an endless buffer as long as the plane says: when a particle comes
/// in, its copy joins the far end, one length behind it. Beyond an outflow particles are taken out
/// when they have gone the plane's length.
template <int Dim>
class Streams {
 public:
  /// h: smoothing length where particles have none of their own [m]; states: of the fluids; gravity
  /// [m/s^2].
  Streams(const SolverSettings& settings, double h, MaterialTable states, const Vec<Dim>& gravity)
      : planes_(settings), h_(h), states_(std::move(states)), gravity_(gravity) {}

  /// Before the first step.
  void begin(const ParticleSet<Dim>& particles);

  /// Where particles have smoothing lengths of their own: sets those, and densities, of the fluid
  /// beyond each inflow to what a buffer without ends has, for it may keep them for a while.
  void settleBuffers(const SolverSettings& settings, const typename Engine<Dim>::Options& options,
                     const StepPasses<Dim>& passes, Scene<Dim>& scene) const;

  /// To be called before and after particles move by v dt [s]. `afterMove` adds and
  /// takes out particles. Throws RunError for fluid that goes the wrong way through a plane.
  void beforeMove(const ParticleSet<Dim>& particles);
  void afterMove(Engine<Dim>& engine, ParticleSet<Dim>& particles, double dt);

  /// To be called when accelerations have been stored: takes those of held fluid, and their
  /// heating, away and notes the power that is lost so.
  void hold(ParticleSet<Dim>& particles);
  /// The last accelerations act for a while [s].
  void act(double duration);

  const StreamBalance<Dim>& balance() const { return balance_; }

  /// For files that a run goes on from.
  std::vector<std::pair<std::string, double>> progress() const;
  /// Throws InputError if a figure is missing.
  void restore(const std::vector<std::pair<std::string, double>>& progress);

 private:
  struct Rates {
    double power = 0;  // [W]
    Vec<Dim> force{};  // [N]
    Rates& operator+=(const Rates& other);
  };

  /// What becomes of a particle after it moved.
  enum class Fate : std::uint8_t { stays, comesIn, leaves, comesBack };

  Fate fateOf(const ParticleSet<Dim>& particles, std::size_t i) const;
  void sendBack(ParticleSet<Dim>& particles, std::size_t first);
  template <class Indices>
  void count(const ParticleSet<Dim>& particles, const Indices& indices, double sign, double dt);
  [[noreturn]] void failBackwards(const ParticleSet<Dim>& particles, std::size_t i) const;

  StreamPlanes<Dim> planes_;
  double h_;
  MaterialTable states_;
  Vec<Dim> gravity_;
  std::vector<std::uint8_t> wasInBuffer_;  // of each fluid particle, before it moved
  std::uint64_t nextId_ = 1;
  Rates held_;  // what was taken from held fluid when accelerations were stored last
  StreamBalance<Dim> balance_;
};

extern template class Streams<1>;
extern template class Streams<2>;
extern template class Streams<3>;

}  // namespace plenum
