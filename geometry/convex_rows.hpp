// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/rows.hpp"

#include <cmath>
#include <limits>

namespace plenum {

/// The points x + t step with begin <= t <= end; none if begin > end.
struct Chord {
  double begin = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();

  bool isEmpty() const { return !(begin <= end); }
  static Chord empty() { return {1, 0}; }
  Chord common(const Chord& other) const {
    return {std::fmax(begin, other.begin), std::fmin(end, other.end)};
  }
};

/// Where the slab lower <= x + t rate <= upper is met.
inline Chord chordOfSlab(double x, double rate, double lower, double upper) {
  if (!(lower <= upper)) return Chord::empty();
  if (rate == 0) return lower <= x && x <= upper ? Chord{} : Chord::empty();
  const double a = (lower - x) / rate;
  const double b = (upper - x) / rate;
  return rate > 0 ? Chord{a, b} : Chord{b, a};
}

/// Where |x + t rate| <= radius; `rate` is not zero.
template <int Dim>
Chord chordOfBall(const Vec<Dim>& x, const Vec<Dim>& rate, double radius) {
  if (!(radius >= 0)) return Chord::empty();
  const double squared = normSquared(rate);
  const double middle = -dot(x, rate) / squared;
  // From the foot of the centre, so that nothing cancels where the row touches the ball.
  const double inner = radius * radius - normSquared(x + middle * rate);
  if (!(inner >= 0)) return Chord::empty();
  const double half = std::sqrt(inner / squared);
  return {middle - half, middle + half};
}

/// Rows of a convex shape that has
///   Chord chord(const Vec<Dim>& x, const Vec<Dim>& step, double grow) const;
/// where x + t step lies in the shape grown by `grow` [m] or more. If negative: in the shape shrunk
/// by as much or more.
template <class Shape, int Dim>
void classifyConvex(const Shape& shape, std::span<const Row<Dim>> rows, const Vec<Dim>& step,
                    double near, RowRuns& runs) {
  runs.clear();
  for (const Row<Dim>& row : rows) {
    const auto n = static_cast<double>(row.count);
    const auto from = [&](double t) {
      return static_cast<std::int64_t>(std::ceil(std::fmin(std::fmax(t, 0), n)));
    };
    const auto past = [&](double t) {
      return static_cast<std::int64_t>(std::floor(std::fmin(std::fmax(t, -1), n - 1))) + 1;
    };
    const Chord whole = shape.chord(row.first, step, near);
    if (!whole.isEmpty()) {
      const Chord core = shape.chord(row.first, step, -near);
      runs.add(from(whole.begin), PointPlace::outside);
      if (!core.isEmpty()) {
        runs.add(from(core.begin), PointPlace::unknown);
        runs.add(past(core.end), PointPlace::inside);
      }
      runs.add(past(whole.end), PointPlace::unknown);
    }
    runs.add(row.count, PointPlace::outside);
    runs.endRow();
  }
}

}  // namespace plenum
