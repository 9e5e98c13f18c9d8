// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/analytic.hpp"
#include "geometry/print.hpp"

#include <algorithm>
#include <limits>

namespace plenum {

/// An axis-aligned box: an interval in 1-D, a rectangle in 2-D.
template <int Dim>
struct BoxShape {
  static constexpr int dimension = Dim;
  Box<Dim> box;  ///< [m]

  SurfacePoint<Dim> closest(const Vec<Dim>& x) const {
    Vec<Dim> nearest = x;
    for (int a = 0; a < Dim; ++a) nearest[a] = std::clamp(x[a], box.lower[a], box.upper[a]);
    const double distance = norm(x - nearest);
    if (distance > 0) return {nearest, (x - nearest) / distance, distance};
    return closestFromInside(x);
  }

  Chord chord(const Vec<Dim>& x, const Vec<Dim>& step, double grow) const {
    Chord chord;
    for (int a = 0; a < Dim; ++a)
      chord = chord.common(chordOfSlab(x[a], step[a], box.lower[a] - grow, box.upper[a] + grow));
    return chord;
  }

  Box<Dim> bounds() const { return box; }
  double volume() const { return box.volume(); }
  std::string describe() const {
    return fmt::format("box from {} to {}", printed(box.lower), printed(box.upper));
  }

 private:
  SurfacePoint<Dim> closestFromInside(const Vec<Dim>& x) const {
    SurfacePoint<Dim> hit{x, {}, -std::numeric_limits<double>::infinity()};
    for (int a = 0; a < Dim; ++a)
      for (const double side : {-1.0, 1.0}) {
        const double wall = side < 0 ? box.lower[a] : box.upper[a];
        const double distance = side * (x[a] - wall);
        if (distance <= hit.signedDistance) continue;
        hit = {x, side * unitVector<Dim>(a), distance};
        hit.point[a] = wall;
      }
    return hit;
  }
};

/// All points on one side of a plane (a line in 2-D, a point in 1-D): normal . (x - point) <= 0.
template <int Dim>
struct HalfSpace {
  static constexpr int dimension = Dim;
  Vec<Dim> point;   ///< on the plane [m]
  Vec<Dim> normal;  ///< unit, out of the region

  SurfacePoint<Dim> closest(const Vec<Dim>& x) const {
    const double distance = dot(normal, x - point);
    return {x - distance * normal, normal, distance};
  }

  Chord chord(const Vec<Dim>& x, const Vec<Dim>& step, double grow) const {
    return chordOfSlab(dot(normal, x - point), dot(normal, step),
                       -std::numeric_limits<double>::infinity(), grow);
  }

  Box<Dim> bounds() const {
    Box<Dim> box;
    box.upper = Vec<Dim>::filled(std::numeric_limits<double>::infinity());
    box.lower = -box.upper;
    for (int a = 0; a < Dim; ++a) {
      if (normal[a] == 1) box.upper[a] = point[a];
      if (normal[a] == -1) box.lower[a] = point[a];
    }
    return box;
  }

  double volume() const { return std::numeric_limits<double>::infinity(); }
  std::string describe() const {
    return fmt::format("half-space at {} with outward normal {}", printed(point), printed(normal));
  }
};

}  // namespace plenum
