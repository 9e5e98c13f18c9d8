// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace plenum {
namespace {

// Coordinates are integers of up to 30 bits over 2^30: the determinant fits into 64 bits.
TEST(Orientation, AgreesWithIntegers) {
  std::mt19937 random(1);
  const auto sign = [](std::int64_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
  int nZero = 0;
  for (int k = 0; k < 200000; ++k) {
    const int bits = 2 + k % 29;
    std::int64_t c[6];
    for (auto& x : c) x = static_cast<std::int64_t>(random() & ((1u << bits) - 1));
    if (k % 3 == 0) {  // on the line, or next to it
      c[4] = 2 * c[2] - c[0];
      c[5] = 2 * c[3] - c[1] + static_cast<std::int64_t>(random() % 3) - 1;
    }
    const std::int64_t exact = (c[0] - c[4]) * (c[3] - c[5]) - (c[1] - c[5]) * (c[2] - c[4]);
    const auto at = [&](int i) {
      return Vec<2>{{std::ldexp(double(c[i]), -30), std::ldexp(double(c[i + 1]), -30)}};
    };
    ASSERT_EQ(orientation(at(0), at(2), at(4)), sign(exact));
    ASSERT_EQ(orientation(at(2), at(0), at(4)), -sign(exact));
    nZero += exact == 0;
  }
  EXPECT_GT(nZero, 1000);
}

// Neighbouring doubles beside a line through points far apart: the rounded determinant is noise.
TEST(Orientation, TellsTheLastBit) {
  const Vec<2> a{{12, 12}};
  const Vec<2> b{{24, 24}};
  for (double x = 0.5; x < 0.5 + 200 * 0x1p-53; x += 0x1p-53)
    for (double y = 0.5; y < 0.5 + 200 * 0x1p-53; y += 0x1p-53)
      ASSERT_EQ(orientation(a, b, {{x, y}}), y > x ? 1 : y < x ? -1 : 0);
}

}  // namespace
}  // namespace plenum
