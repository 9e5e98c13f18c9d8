// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/scene.hpp"

#include <span>

namespace plenum {

/// Moves wall particles rigidly. Positions come from the reference positions, which the particles
/// carry, and the time since then, not step by step: a shaft stays round after any number of turns,
/// and a run that was stopped and resumed has the same bits.
template <int Dim>
class WallMotion {
 public:
  /// If some wall moves and the particles carry no reference yet, where they stand now is the
  /// reference, and the scene's time is its startTime.
  explicit WallMotion(Scene<Dim>& scene);

  /// True if a wall with particles has a motion.
  bool anyMoves() const { return anyMoves_; }

  /// Sets positions (wrapped into the periodic domain), velocities and normals of all moving walls
  /// to those at `time` [s]. Returns the longest way that one of them went [m].
  double moveTo(double time, ParticleSet<Dim>& particles);

  /// Acceleration [m/s^2] at `time` [s] of the point of wall `wall` that is at `point` [m]. In a
  /// periodic domain `point` must not be wrapped if the wall rotates.
  Vec<Dim> acceleration(std::size_t wall, const Vec<Dim>& point, double time) const;

  /// The accelerations of all wall particles at `time` [s]; length nWalls().
  void accelerations(double time, const ParticleSet<Dim>& particles, std::span<Vec<Dim>> result);

  /// How much faster than itself the surface before each wall particle moves [m/s], which differs
  /// where a wall turns: angular velocity x (depth normal) at `time` [s]; length nWalls().
  void towardsSurface(double time, const ParticleSet<Dim>& particles, std::span<Vec<Dim>> result);

  /// Where the centres of rotation of the walls are at `time` [m].
  std::vector<Vec<Dim>> centers(double time) const;

 private:
  /// Where a wall is at one time.
  struct Pose {
    Displacement displacement;
    MotionState state;
  };
  void setPoses(double time);

  std::vector<Wall> walls_;
  Box<Dim> domain_;
  double startTime_;
  bool anyMoves_ = false;
  std::vector<Pose> poses_;  // of the walls, in the current call
};

extern template class WallMotion<1>;
extern template class WallMotion<2>;
extern template class WallMotion<3>;

}  // namespace plenum
