// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plenum::study {
namespace {

using Places = std::vector<std::size_t>;

TEST(ParetoFront, HasWhatNobodyBeatsByRisingCost) {
  EXPECT_EQ(paretoFront({{4, 1}, {1, 3}, {2, 3.5}, {2, 2}, {5, 1}}), (Places{1, 3, 0}));
}

TEST(ParetoFront, TakesOneOfEqualPoints) {
  EXPECT_EQ(paretoFront({{1, 1}, {1, 1}, {1, 2}}), Places{0});
  EXPECT_TRUE(paretoFront({}).empty());
}

/// The brute-force definition, on points in no order.
TEST(ParetoFront, IsWhatItsDefinitionSays) {
  std::vector<CostAndError> points;
  for (int k = 1; k < 200; ++k)
    points.push_back({std::fmod(k * 0.618, 1) + 0.1, std::fmod(k * 0.414, 1) + 0.1});
  Places expected;
  for (std::size_t a = 0; a < points.size(); ++a) {
    bool beaten = false;
    for (const CostAndError& b : points)
      beaten |= b.cost <= points[a].cost && b.error <= points[a].error &&
                (b.cost < points[a].cost || b.error < points[a].error);
    if (!beaten) expected.push_back(a);
  }
  Places found = paretoFront(points);
  std::ranges::sort(found);
  EXPECT_EQ(found, expected);
}

/// Errors that fall with the square of the cost: logarithms are linear, so values between are exact
/// to rounding.
TEST(CostAtError, FollowsPowerLawsBetweenPoints) {
  const std::vector<CostAndError> points{{1, 1}, {4, 1.0 / 16}, {2, 0.25}, {3, 0.5}};
  for (const double cost : {1.0, 1.3, 2.0, 3.7, 4.0})
    EXPECT_NEAR(costAtError(points, 1 / (cost * cost)).value(), cost, 1e-12);
}

TEST(CostAtError, SaysNothingBeyondTheFront) {
  const std::vector<CostAndError> points{{1, 1}, {4, 0.5}};
  EXPECT_FALSE(costAtError(points, 1.01));
  EXPECT_FALSE(costAtError(points, 0.49));
  EXPECT_FALSE(costAtError({{1, 1}}, 0.9));
  EXPECT_EQ(costAtError({{1, 1}}, 1), 1);
}

}  // namespace
}  // namespace plenum::study
