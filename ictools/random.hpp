// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"

#include <cstdint>
#include <random>

namespace plenum {

/// Random numbers that are the same on every platform: the standard fixes the generator, but not
/// its distributions, so the mapping to [0, 1) is ours.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  /// Uniform in [0, 1), 53 bits.
  double number() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }

  /// Uniform in a finite box.
  template <int Dim>
  Vec<Dim> pointIn(const Box<Dim>& box) {
    Vec<Dim> x;
    for (int a = 0; a < Dim; ++a) x[a] = box.lower[a] + number() * (box.upper[a] - box.lower[a]);
    return x;
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace plenum
