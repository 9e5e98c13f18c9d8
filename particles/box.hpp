// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vec.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace plenum {

/// An axis-aligned box [m]; each axis is open or periodic.
template <int Dim>
struct Box {
  Vec<Dim> lower{};
  Vec<Dim> upper{};
  std::array<bool, Dim> periodic{};

  /// The box that contains nothing; `extend` grows it.
  static Box nothing() {
    Box box;
    box.lower = Vec<Dim>::filled(std::numeric_limits<double>::infinity());
    box.upper = -box.lower;
    return box;
  }

  Vec<Dim> extent() const { return upper - lower; }
  Vec<Dim> center() const { return 0.5 * (lower + upper); }

  bool isPeriodic(int axis) const { return periodic[static_cast<std::size_t>(axis)]; }
  bool anyPeriodic() const {
    for (bool p : periodic)
      if (p) return true;
    return false;
  }

  double volume() const {
    double product = 1;
    for (int a = 0; a < Dim; ++a) product *= upper[a] - lower[a];
    return product;
  }

  bool contains(const Vec<Dim>& x) const {
    for (int a = 0; a < Dim; ++a)
      if (x[a] < lower[a] || x[a] > upper[a]) return false;
    return true;
  }

  bool isFinite() const {
    for (int a = 0; a < Dim; ++a)
      if (!std::isfinite(lower[a]) || !std::isfinite(upper[a])) return false;
    return true;
  }

  Box& extend(const Vec<Dim>& x) {
    for (int a = 0; a < Dim; ++a) {
      lower[a] = std::fmin(lower[a], x[a]);
      upper[a] = std::fmax(upper[a], x[a]);
    }
    return *this;
  }

  Box& extend(const Box& other) {
    for (int a = 0; a < Dim; ++a) {
      lower[a] = std::fmin(lower[a], other.lower[a]);
      upper[a] = std::fmax(upper[a], other.upper[a]);
    }
    return *this;
  }

  /// The box with `margin` [m] added on every side.
  Box grown(double margin) const {
    Box box = *this;
    box.lower -= Vec<Dim>::filled(margin);
    box.upper += Vec<Dim>::filled(margin);
    return box;
  }

  /// `x` moved by whole periods into [lower, upper) along periodic axes.
  Vec<Dim> wrap(Vec<Dim> x) const {
    for (int a = 0; a < Dim; ++a) {
      if (!isPeriodic(a)) continue;
      const double length = upper[a] - lower[a];
      x[a] -= length * std::floor((x[a] - lower[a]) / length);
      if (x[a] >= upper[a]) x[a] = lower[a];  // a tiny negative number rounds up to the period
    }
    return x;
  }

  /// The shortest of all periodic images of the difference `d`.
  Vec<Dim> nearestImage(Vec<Dim> d) const {
    for (int a = 0; a < Dim; ++a)
      if (isPeriodic(a))
        d[a] -= (upper[a] - lower[a]) * std::nearbyint(d[a] / (upper[a] - lower[a]));
    return d;
  }
};

}  // namespace plenum
