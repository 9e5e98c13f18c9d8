// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"
#include "particles/number.hpp"

#include <limits>

namespace plenum {

/// The periods of a box. Valid for
/// differences shorter than 1.5 periods, which holds for particles that were wrapped when the
/// neighbour list was made.
template <int Dim>
struct Periodicity {
  Vec<Dim> period{};                                                          // 0 on open axes [m]
  Vec<Dim> half = Vec<Dim>::filled(std::numeric_limits<double>::infinity());  // half a period [m]

  Periodicity() = default;
  explicit Periodicity(const Box<Dim>& box) {
    for (int a = 0; a < Dim; ++a)
      if (box.isPeriodic(a)) {
        period[a] = box.upper[a] - box.lower[a];
        half[a] = 0.5 * period[a];
      }
  }

  Vec<Dim> nearestImage(Vec<Dim> d) const {
    for (int a = 0; a < Dim; ++a) {
      d[a] -= select(d[a] > half[a], period[a], 0.0);
      d[a] += select(d[a] < -half[a], period[a], 0.0);
    }
    return d;
  }
};

}  // namespace plenum
