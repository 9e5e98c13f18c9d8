// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/box.hpp"
#include "particles/vec.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace plenum {
namespace {

TEST(Vec, Arithmetic) {
  constexpr Vec<3> a{{1, 2, 3}}, b{{4, -5, 6}};
  static_assert(a + b == Vec<3>{{5, -3, 9}});
  static_assert(a - b == Vec<3>{{-3, 7, -3}});
  static_assert(2.0 * a == a * 2.0 && -a == Vec<3>{{-1, -2, -3}});
  static_assert(dot(a, b) == 12 && normSquared(a) == 14);
  EXPECT_EQ(norm(Vec<2>{{3, 4}}), 5);
  EXPECT_EQ((a / 2.0), (Vec<3>{{0.5, 1, 1.5}}));
  EXPECT_EQ(Vec<2>::filled(7), (Vec<2>{{7, 7}}));
}

TEST(Vec, ThreeComponentsAndBack) {
  EXPECT_EQ(toThree(Vec<1>{{5}}), (std::array<double, 3>{5, 0, 0}));
  EXPECT_EQ(toThree(Vec<3>{{5, 6, 7}}), (std::array<double, 3>{5, 6, 7}));
  EXPECT_EQ(fromThree<2>({5, 6, 7}), (Vec<2>{{5, 6}}));
}

TEST(Box, GrowsFromNothing) {
  Box<2> box = Box<2>::nothing();
  EXPECT_FALSE(box.isFinite());
  box.extend(Vec<2>{{1, 2}}).extend(Vec<2>{{-1, 5}});
  EXPECT_EQ(box.lower, (Vec<2>{{-1, 2}}));
  EXPECT_EQ(box.upper, (Vec<2>{{1, 5}}));
  EXPECT_EQ(box.volume(), 6);
  EXPECT_EQ(box.center(), (Vec<2>{{0, 3.5}}));
  EXPECT_TRUE(box.contains({{1, 2}}));
  EXPECT_FALSE(box.contains({{1.001, 2}}));
  EXPECT_EQ(box.grown(1).lower, (Vec<2>{{-2, 1}}));
}

Box<2> periodicInX() { return {{{-1, -1}}, {{2, 1}}, {true, false}}; }

TEST(Box, WrapsPeriodicAxesOnly) {
  const Box<2> box = periodicInX();
  EXPECT_TRUE(box.anyPeriodic());
  EXPECT_EQ(box.wrap({{2.5, 7}}), (Vec<2>{{-0.5, 7}}));
  EXPECT_EQ(box.wrap({{-7.5, 0}}), (Vec<2>{{1.5, 0}}));
  EXPECT_EQ(box.wrap({{2, 0}}), (Vec<2>{{-1, 0}})) << "the upper end is the lower one";
  EXPECT_EQ(box.wrap({{-1, 0}}), (Vec<2>{{-1, 0}}));
}

TEST(Box, WrapOfTinyNegativesStaysBelowTheUpperEnd) {
  const Box<1> unit{{{0}}, {{1}}, {true}};
  // x + 1 rounds to 1 for these: the result must still be inside [0, 1).
  for (double x : {-1e-17, -1e-300, -std::numeric_limits<double>::denorm_min(), -1.1e-16}) {
    const double y = unit.wrap({{x}})[0];
    EXPECT_GE(y, 0) << x;
    EXPECT_LT(y, 1) << x;
  }
}

TEST(Box, WrapIsIdempotentAndMovesByWholePeriods) {
  const Box<1> box{{{-0.3}}, {{0.7}}, {true}};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-50, 50);
  for (int k = 0; k < 10000; ++k) {
    const double x = uniform(random);
    const double y = box.wrap({{x}})[0];
    ASSERT_GE(y, -0.3);
    ASSERT_LT(y, 0.7);
    ASSERT_EQ(box.wrap({{y}})[0], y);
    // x - y is a whole number but for the rounding of numbers below 50 (7e-15 each, two of them).
    ASSERT_NEAR(x - y, std::round(x - y), 2e-14);
  }
}

TEST(Box, NearestImage) {
  const Box<2> box = periodicInX();  // period 3 along x
  EXPECT_EQ(box.nearestImage({{2, 5}}), (Vec<2>{{-1, 5}}));
  EXPECT_EQ(box.nearestImage({{-2, 0}}), (Vec<2>{{1, 0}}));
  EXPECT_EQ(box.nearestImage({{-1e-300, 0}}), (Vec<2>{{-1e-300, 0}}));
  EXPECT_EQ(std::fabs(box.nearestImage({{1.5, 0}})[0]), 1.5);
  EXPECT_EQ(box.nearestImage({{3, 0}})[0], 0);
  // The image of an odd function is odd: pairs see each other with opposite signs.
  for (double d = -4.4; d < 4.5; d += 0.37)
    EXPECT_EQ(box.nearestImage({{d, 0}})[0], -box.nearestImage({{-d, 0}})[0]) << d;
}

}  // namespace
}  // namespace plenum
