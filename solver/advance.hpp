// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"

#include <cmath>
#include <optional>

namespace plenum {

/// How a change of all values went.
struct Advanced {
  double largestChange = 0;
  std::optional<std::size_t> bad;  ///< the first particle whose new value is not sound
};

inline double squareOf(double x) { return x * x; }
template <int Dim>
double squareOf(const Vec<Dim>& v) {
  return normSquared(v);
}

/// values[i] = next(i, values[i], sum of i) for all fluids, or for walls too. If some result is not
/// sound, all are taken back by `previous` (to rounding).
template <class Value, class Sums, class Next, class Previous, class IsSound>
Advanced advance(std::span<Value> values, const Sums& sums, bool wallsToo, Next&& next,
                 Previous&& previous, IsSound&& isSound) {
  const std::size_t nClusters = sums.nClusters(wallsToo), none = values.size();
  std::size_t bad = none;
  double largest = 0;
#pragma omp parallel for schedule(static) reduction(min    \
                                                    : bad) \
    reduction(max                                          \
              : largest) if (none >= worthThreads)
  for (std::size_t c = 0; c < nClusters; ++c)
    sums.forEach(c, [&](std::size_t i, const auto& sum) {
      const Value value = next(i, values[i], sum);
      if (isSound(value)) {
        largest = std::max(largest, squareOf(value - values[i]));
        values[i] = value;
      } else {
        bad = std::min(bad, i);
      }
    });
  if (bad == none) return {std::sqrt(largest), std::nullopt};
  for (std::size_t c = 0; c < nClusters; ++c)
    sums.forEach(c, [&](std::size_t i, const auto& sum) {
      const Value value = previous(i, values[i], sum);
      if (isSound(value)) values[i] = value;  // else it was not changed
    });
  return {0, bad};
}

}  // namespace plenum
