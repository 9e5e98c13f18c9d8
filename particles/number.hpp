// SPDX-License-Identifier: GPL-3.0-or-later
//
// The few functions that formulas need of a number type. A pack of numbers overloads the same
// names.
#pragma once

#include <cmath>
#include <concepts>

namespace plenum {

template <std::floating_point Real>
constexpr Real max(Real a, Real b) {
  return a > b ? a : b;
}

template <std::floating_point Real>
constexpr Real min(Real a, Real b) {
  return a < b ? a : b;
}

template <std::floating_point Real>
constexpr Real select(bool condition, Real yes, Real no) {
  return condition ? yes : no;
}

template <std::floating_point Real>
Real squareRoot(Real a) {
  return std::sqrt(a);
}

/// max(a, 0) and min(a, 0), exactly, but without a branch that is taken at random.
template <std::floating_point Real>
constexpr Real positivePart(Real a) {
  return Real(0.5) * (a + std::abs(a));
}

template <std::floating_point Real>
constexpr Real negativePart(Real a) {
  return Real(0.5) * (a - std::abs(a));
}

/// a^N by repeated squaring.
template <int N, class Real>
constexpr Real power(Real a) {
  static_assert(N >= 0);
  if constexpr (N == 0)
    return Real(1);
  else if constexpr (N == 1)
    return a;
  else if constexpr (N % 2 == 0)
    return power<N / 2>(a * a);
  else
    return a * power<N - 1>(a);
}

}  // namespace plenum
