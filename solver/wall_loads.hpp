// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"
#include "particles/scene.hpp"

#include <array>
#include <vector>

namespace plenum {

/// What the fluid does to one wall; about the wall's centre of rotation. A force [N] and a
/// torque [N m], or what they add up to over a time.
struct WallLoad {
  std::array<double, 3> force{};
  std::array<double, 3> torque{};

  WallLoad& operator+=(const WallLoad& other);
  friend WallLoad operator*(double factor, WallLoad load);
};

/// Adds up what walls get from the fluid in every step, so that the mean loads of an interval
/// account for all of the momentum that the fluid lost, to round-off.
template <int Dim>
class WallLoads {
 public:
  explicit WallLoads(std::size_t nWalls) : now_(nWalls), impulses_(nWalls) {}

  /// Takes the forces that the last pass summed for the loads of now. centers: of rotation now, of
  /// each wall [m]. The result does not depend on the number of threads.
  void setForces(const Engine<Dim>& engine, const ParticleSet<Dim>& particles,
                 std::span<const Vec<Dim>> centers);
  /// The forces of now act for a while [s].
  void act(double duration);
  /// Adds the impulses that the last pass summed.
  void addImpulses(const Engine<Dim>& engine, const ParticleSet<Dim>& particles,
                   std::span<const Vec<Dim>> centers);

  /// The time of a step has passed [s].
  void elapse(double dt) { elapsed_ += dt; }

  /// Mean loads since the last call of `restart`; zero if no time has passed.
  std::vector<WallLoad> means() const;
  void restart();

  /// For files that a run goes on from.
  std::vector<std::pair<std::string, double>> progress() const;
  void restore(const std::vector<std::pair<std::string, double>>& progress);

 private:
  std::vector<WallLoad> now_;       // forces
  std::vector<WallLoad> impulses_;  // since the last restart
  double elapsed_ = 0;
};

extern template class WallLoads<1>;
extern template class WallLoads<2>;
extern template class WallLoads<3>;

}  // namespace plenum
