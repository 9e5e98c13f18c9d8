// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "particles/scene.hpp"

namespace plenum {

/// A rigid motion from one time to another: x -> centerAfter + turn (x - centerBefore).
struct Displacement {
  std::array<std::array<double, 3>, 3> turn{};
  std::array<double, 3> centerBefore{}, centerAfter{};

  Displacement(const RigidMotion& motion, double before, double after);

  template <int Dim>
  Vec<Dim> turned(const Vec<Dim>& direction) const;
  template <int Dim>
  Vec<Dim> moved(const Vec<Dim>& x) const {
    return fromThree<Dim>(centerAfter) + turned(x - fromThree<Dim>(centerBefore));
  }
};

/// Velocity [m/s] of a rigid motion at point x when its centre is at `center`.
template <int Dim>
Vec<Dim> velocityAt(const RigidMotion& motion, const Vec<Dim>& x, const Vec<Dim>& center);

/// Moves wall particles rigidly. Positions come from the state at the start of the run and the
/// elapsed time, not step by step, so that a shaft stays round after any number of turns.
template <int Dim>
class WallMotion {
 public:
  /// Remembers where the walls are at `startTime` [s]; moves nothing if none has a motion. Throws
  /// InputError if the ids of the wall particles are not consecutive, as `plenum-ic` numbers them.
  WallMotion(std::vector<Wall> walls, const ParticleSet<Dim>& particles, const Box<Dim>& domain,
             double startTime);

  /// Sets positions (wrapped into the periodic domain), velocities and normals of all moving walls
  /// to those at `time` [s]. Returns the longest way that one of them went [m].
  double moveTo(double time, ParticleSet<Dim>& particles);

  /// Acceleration [m/s^2] of a point x that moves with a wall.
  Vec<Dim> acceleration(std::int32_t wall, const Vec<Dim>& x, double time) const;
  /// Where the centres of rotation of the walls are [m].
  std::vector<Vec<Dim>> centers(double time) const;

 private:
  struct Start {
    Vec<Dim> position;
    Vec<Dim> normal;
  };

  std::vector<Wall> walls_;
  Box<Dim> domain_;
  double startTime_;
  std::uint64_t firstId_ = 0;                // smallest id of a wall particle
  std::vector<Start> start_;                 // by id - firstId_; empty if no wall moves
  std::vector<Displacement> displacements_;  // per wall, of the current call
};

extern template class WallMotion<1>;
extern template class WallMotion<2>;
extern template class WallMotion<3>;

}  // namespace plenum
