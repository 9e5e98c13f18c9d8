// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rigid motions that are known in advance: those of walls. All of a wall turns about one axis,
// whose direction is fixed and whose centre moves along with the translation.
#pragma once

#include "particles/vec.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace plenum {

/// A number that depends on time, with its first and second derivative.
struct Signal {
  double value = 0, rate = 0, secondRate = 0;
};

/// g(t) - g(from), where g(t) = e(t) sin(2 pi frequency (t - from) + phase) for from <= t < until;
/// zero before, constant after. e = 1 without a ramp. With one, e = S((t - from)/ramp) at first and
/// S((until - t)/ramp) at last, S(q) = q^3 (10 - 15 q + 6 q^2): value, rate and second rate then
/// have no jump, and the value ends at zero.
struct Harmonic {
  double frequency = 0;                                    ///< [1/s]
  double phase = 0;                                        ///< [rad]
  double from = 0;                                         ///< [s], not negative
  double until = std::numeric_limits<double>::infinity();  ///< [s]
  double ramp = 0;                                         ///< [s], at most (until - from)/2

  Signal at(double time) const;
  bool operator==(const Harmonic&) const = default;
};

/// Translation along a line: amplitude [m] times a harmonic signal.
struct Oscillation {
  std::array<double, 3> amplitude{};
  Harmonic harmonic = {};
  bool operator==(const Oscillation&) const = default;
};

/// Rotation to and fro: amplitude [rad] times a harmonic signal.
struct Rocking {
  double amplitude = 0;
  Harmonic harmonic = {};
  bool operator==(const Rocking&) const = default;
};

/// Places at some times and cubic Hermite interpolation between them. The tangent at a row is that
/// of the parabola through it and its neighbours (Catmull-Rom's for rows that are evenly spaced in
/// time): velocity is continuous, and of second order, the place of third, where a monotone spline
/// would cut off the peaks of an oscillation. At the first and the last row the tangent is zero,
/// because the wall stands still before and after.
struct MotionTable {
  static constexpr std::size_t nColumns = 4;

  std::vector<double> times;                         ///< increasing [s]
  std::vector<std::array<double, nColumns>> places;  ///< x, y, z [m] and angle [rad] of each time

  bool empty() const { return times.empty(); }
  /// The columns at a time; all zero if the table is empty.
  std::array<Signal, nColumns> at(double time) const;
  bool operator==(const MotionTable&) const = default;

 private:
  double tangent(std::size_t row, std::size_t column) const;
};

/// The sum of constant, harmonic and tabulated translations and rotations. In 2-D only the third
/// component of angular velocity and axis counts.
struct RigidMotion {
  std::array<double, 3> velocity{};         ///< constant [m/s]
  std::array<double, 3> angularVelocity{};  ///< constant [rad/s]
  std::array<double, 3> center{};           ///< at t = 0 [m]
  /// Unit vector about which it rocks and the table turns it; parallel to angularVelocity.
  std::array<double, 3> axis{0, 0, 1};
  Oscillation oscillation = {};
  Rocking rocking = {};
  MotionTable table = {};  ///< counts from its place at t = 0

  bool isStill() const;
  bool operator==(const RigidMotion&) const = default;
};

/// What makes a motion senseless (not finite, times that do not increase, ...), if anything does.
std::optional<std::string> faultOf(const RigidMotion& motion);

/// A rigid motion at a time: a point x of it has the velocity
/// velocity + angularVelocity x (x - center).
struct MotionState {
  std::array<double, 3> center{};               ///< [m]
  std::array<double, 3> velocity{};             ///< of the centre [m/s]
  std::array<double, 3> acceleration{};         ///< of the centre [m/s^2]
  std::array<double, 3> angularVelocity{};      ///< [rad/s]
  std::array<double, 3> angularAcceleration{};  ///< [rad/s^2]

  /// At a time [s]. Where a rate jumps (a motion begins without a ramp), the later value holds.
  MotionState(const RigidMotion& motion, double time);

  /// Velocity [m/s] of the material point that is at x [m].
  template <int Dim>
  Vec<Dim> velocityAt(const Vec<Dim>& x) const;

  /// Its acceleration: acceleration + angularAcceleration x r + angularVelocity x
  /// (angularVelocity x r), r = x - center [m/s^2].
  template <int Dim>
  Vec<Dim> accelerationAt(const Vec<Dim>& x) const;
};

/// A rigid motion from one time [s] to another: x -> centerAfter + turn (x - centerBefore). Each
/// depends on the two times alone, so that nothing adds up over many turns.
struct Displacement {
  std::array<std::array<double, 3>, 3> turn{};
  std::array<double, 3> centerBefore{}, centerAfter{};

  Displacement(const RigidMotion& motion, double before, double after);

  template <int Dim>
  Vec<Dim> turned(const Vec<Dim>& direction) const {
    Vec<Dim> result;
    for (int a = 0; a < Dim; ++a)
      for (int b = 0; b < Dim; ++b)
        result[a] += turn[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] * direction[b];
    return result;
  }
  template <int Dim>
  Vec<Dim> moved(const Vec<Dim>& x) const {
    return fromThree<Dim>(centerAfter) + turned(x - fromThree<Dim>(centerBefore));
  }
};

}  // namespace plenum
