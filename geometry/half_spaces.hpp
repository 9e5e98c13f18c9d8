// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vec.hpp"

#include <array>
#include <cstddef>
#include <limits>

namespace plenum {

/// Constraints value + normal . (z - y) <= 0, the eight that matter most.
template <int Dim>
struct Constraints {
  static constexpr int most = 8;
  int n = 0;
  std::array<double, most> value{};  ///< at the point that is projected
  std::array<Vec<Dim>, most> normal{};
  std::array<std::size_t, most> part{};
};

/// The way onto the constraints: shift = -sum of lambda_k normal_k, lambda_k >= 0.
template <int Dim>
struct Projection {
  Vec<Dim> shift{};
  std::array<double, Constraints<Dim>::most> lambda{};
  double violation =
      std::numeric_limits<double>::infinity();  ///< of the worst constraint afterwards [m]
};

/// Tries every set of at most `Dim` active constraints; within `zero` [m] of satisfying all will
/// do. Where none does: the one that comes nearest to it.
template <int Dim>
Projection<Dim> project(const Constraints<Dim>& c, double zero);

}  // namespace plenum
