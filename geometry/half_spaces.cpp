// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/half_spaces.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace plenum {

namespace {

/// Projects onto the constraints `active` taken as equations (Gaussian elimination with pivots);
/// false if they are dependent or if one would have to pull.
template <int Dim>
bool projectOnto(const Constraints<Dim>& c, std::span<const std::size_t> active,
                 Projection<Dim>& result) {
  const std::size_t n = active.size();
  std::array<std::array<double, 4>, 3> m{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = dot(c.normal[active[i]], c.normal[active[j]]);
    m[i][n] = c.value[active[i]];
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    if (std::abs(m[pivot][k]) < 1e-9) return false;
    std::swap(m[k], m[pivot]);
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = n + 1; j-- > k;) m[i][j] -= m[i][k] / m[k][k] * m[k][j];
  }
  result = {};
  for (std::size_t k = n; k-- > 0;) {
    double sum = m[k][n];
    for (std::size_t j = k + 1; j < n; ++j) sum -= m[k][j] * result.lambda[active[j]];
    const double lambda = sum / m[k][k];
    if (lambda < 0) return false;
    result.lambda[active[k]] = lambda;
    result.shift -= lambda * c.normal[active[k]];
  }
  result.violation = 0;
  for (std::size_t k = 0; k < std::size_t(c.n); ++k)
    result.violation = std::max(result.violation, c.value[k] + dot(c.normal[k], result.shift));
  return true;
}

}  // namespace

template <int Dim>
Projection<Dim> project(const Constraints<Dim>& c, double zero) {
  Projection<Dim> best;
  std::array<std::size_t, 3> active{};
  const auto solved = [&](std::size_t n) {
    Projection<Dim> result;
    if (projectOnto(c, std::span<const std::size_t>(active).first(n), result) &&
        result.violation < best.violation)
      best = result;
    return best.violation <= zero;
  };
  if (solved(0)) return best;
  const auto n = std::size_t(c.n);
  for (active[0] = 0; active[0] < n; ++active[0])
    if (solved(1)) return best;
  if constexpr (Dim >= 2)
    for (active[0] = 0; active[0] < n; ++active[0])
      for (active[1] = 0; active[1] < active[0]; ++active[1])
        if (solved(2)) return best;
  if constexpr (Dim >= 3)
    for (active[0] = 0; active[0] < n; ++active[0])
      for (active[1] = 0; active[1] < active[0]; ++active[1])
        for (active[2] = 0; active[2] < active[1]; ++active[2])
          if (solved(3)) return best;
  return best;
}

template Projection<1> project<1>(const Constraints<1>&, double);
template Projection<2> project<2>(const Constraints<2>&, double);
template Projection<3> project<3>(const Constraints<3>&, double);

}  // namespace plenum
