// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/analytic.hpp"
#include "geometry/print.hpp"

#include <algorithm>
#include <numbers>

namespace plenum {

/// A disk (2-D) or ball (3-D).
template <int Dim>
struct Ball {
  static_assert(Dim == 2 || Dim == 3);
  static constexpr int dimension = Dim;
  Vec<Dim> center;    ///< [m]
  double radius = 1;  ///< [m]

  SurfacePoint<Dim> closest(const Vec<Dim>& x) const {
    const Vec<Dim> normal = direction(x - center, unitVector<Dim>(0));
    return {center + radius * normal, normal, norm(x - center) - radius};
  }

  Chord chord(const Vec<Dim>& x, const Vec<Dim>& step, double grow) const {
    return chordOfBall(x - center, step, radius + grow);
  }

  Box<Dim> bounds() const { return Box<Dim>{center, center, {}}.grown(radius); }
  double volume() const {
    constexpr double pi = std::numbers::pi;
    return Dim == 2 ? pi * radius * radius : 4 * pi / 3 * radius * radius * radius;
  }
  std::string describe() const {
    return fmt::format("{} of radius {:.6g} at {}", Dim == 2 ? "disk" : "ball", radius,
                       printed(center));
  }
};

/// The gap between two concentric circles.
struct Annulus {
  static constexpr int dimension = 2;
  Vec<2> center;           ///< [m]
  double innerRadius = 1;  ///< [m]
  double outerRadius = 2;  ///< [m]

  SurfacePoint<2> closest(const Vec<2>& x) const {
    const Vec<2> outward = direction(x - center, unitVector<2>(0));
    const double r = norm(x - center);
    if (r - innerRadius < outerRadius - r)
      return {center + innerRadius * outward, -outward, innerRadius - r};
    return {center + outerRadius * outward, outward, r - outerRadius};
  }

  void classify(std::span<const Row<2>> rows, const Vec<2>& step, double near,
                RowRuns& runs) const {
    RowRuns inner, outer;
    classifyConvex(Ball<2>{center, innerRadius}, rows, step, near, inner);
    classifyConvex(Ball<2>{center, outerRadius}, rows, step, near, outer);
    runs =
        combined(outer, inner, [](PointPlace a, PointPlace b) { return std::min(a, opposite(b)); });
  }

  Box<2> bounds() const { return Box<2>{center, center, {}}.grown(outerRadius); }
  double volume() const {
    return std::numbers::pi * (outerRadius - innerRadius) * (outerRadius + innerRadius);
  }
  std::string describe() const {
    return fmt::format("annulus of radii {:.6g} and {:.6g} at {}", innerRadius, outerRadius,
                       printed(center));
  }
};

/// A cylinder with flat caps at right angles to its axis.
struct Cylinder {
  static constexpr int dimension = 3;
  Vec<3> from;        ///< centre of one cap [m]
  Vec<3> to;          ///< centre of the other [m]
  double radius = 1;  ///< [m]

  SurfacePoint<3> closest(const Vec<3>& x) const {
    const double length = norm(to - from);
    const Vec<3> axis = (to - from) / length;
    const double along = dot(x - from, axis);
    const Vec<3> radial = x - from - along * axis;
    const double r = norm(radial);
    const Vec<3> outward = direction(radial, perpendicular(axis));

    const double pastSide = r - radius;
    const double pastCap = std::max(-along, along - length);
    const bool upperCap = along > 0.5 * length;
    if (pastSide <= 0 && pastCap <= 0 && pastCap > pastSide)
      return {(upperCap ? to : from) + r * outward, upperCap ? axis : -axis, pastCap};
    if (pastCap <= 0) return {from + along * axis + radius * outward, outward, pastSide};

    const Vec<3> nearest = (upperCap ? to : from) + std::min(r, radius) * outward;
    if (pastSide <= 0) return {nearest, upperCap ? axis : -axis, pastCap};
    const double distance = std::hypot(pastSide, pastCap);
    return {nearest, direction(x - nearest, outward), distance};
  }

  Chord chord(const Vec<3>& x, const Vec<3>& step, double grow) const {
    const double length = norm(to - from);
    const Vec<3> axis = (to - from) / length;
    const double along = dot(x - from, axis);
    const double rate = dot(step, axis);
    const Chord between = chordOfSlab(along, rate, -grow, length + grow);
    if (between.isEmpty()) return between;
    const Vec<3> radial = x - from - along * axis;
    const Vec<3> radialRate = step - rate * axis;
    if (norm(radialRate) > 1e-3 * norm(step))
      return between.common(chordOfBall(radial, radialRate, radius + grow));
    // Almost along the axis: a root would be spoilt by round-off, so the whole way between the caps
    // is in or out, with the way to the side as a margin.
    const double aside = norm(radialRate) * (between.end - between.begin);
    const double r = norm(radial + between.begin * radialRate);
    return r + (grow < 0 ? aside : -aside) <= radius + grow ? between : Chord::empty();
  }

  Box<3> bounds() const {
    const Vec<3> axis = (to - from) / norm(to - from);
    Vec<3> reach;  // of a cap along each axis
    for (int a = 0; a < 3; ++a) reach[a] = radius * std::sqrt(std::max(0., 1 - axis[a] * axis[a]));
    Box<3> box = Box<3>::nothing();
    for (const Vec<3>& center : {from, to}) box.extend(center - reach).extend(center + reach);
    return box;
  }

  double volume() const { return std::numbers::pi * radius * radius * norm(to - from); }
  std::string describe() const {
    return fmt::format("cylinder of radius {:.6g} from {} to {}", radius, printed(from),
                       printed(to));
  }

 private:
  static Vec<3> perpendicular(const Vec<3>& axis) {
    int least = 0;
    for (int a = 1; a < 3; ++a)
      if (std::abs(axis[a]) < std::abs(axis[least])) least = a;
    const Vec<3> other = unitVector<3>(least) - axis[least] * axis;
    return other / norm(other);
  }
};

}  // namespace plenum
