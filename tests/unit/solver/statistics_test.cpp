// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace plenum {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN(), all = 1e300;
const std::vector<double> times{0, 1, 3, 4};

Series whole(const std::vector<double>& values) { return seriesOf(times, values, -all, all); }

TEST(Statistics, MeansAreOverTime) {
  const Series s = whole({0, 2, -2, -2});
  EXPECT_EQ(statisticOf(s, "mean"), (1.0 + 0 - 2) / 4);
  EXPECT_EQ(statisticOf(s, "mean_abs"), (1.0 + 4 + 2) / 4);
  // More rows on the same straight lines change nothing.
  const std::vector<double> more{0, 0.5, 1, 3, 3.5, 4};
  EXPECT_EQ(
      statisticOf(seriesOf(more, std::vector<double>{0, 1, 2, -2, -2, -2}, -all, all), "mean"),
      -0.25);
  EXPECT_EQ(statisticOf(seriesOf(times, std::vector<double>{0, 2, -2, -2}, 1, 1), "mean"), 2);
}

TEST(Statistics, OthersAreOverRows) {
  const Series s = whole({1, 2, -2, 0});
  EXPECT_EQ(statisticOf(s, "last"), 0);
  EXPECT_EQ(statisticOf(s, "min"), -2);
  EXPECT_EQ(statisticOf(s, "max"), 2);
  EXPECT_EQ(statisticOf(s, "drift"), 3);
  EXPECT_EQ(statisticOf(whole({-2, 1, -3, 0}), "relative_drift"), 1.5);
  EXPECT_TRUE(std::isnan(statisticOf(whole({0, 1, 2, 3}), "relative_drift")));
  EXPECT_THROW(statisticOf(s, "median"), std::invalid_argument);
}

TEST(Statistics, WindowsIncludeTheirEnds) {
  const std::vector<double> values{1, 5, 3, 9};
  EXPECT_EQ(statisticOf(seriesOf(times, values, 1, 3), "max"), 5);
  EXPECT_EQ(statisticOf(seriesOf(times, values, 1, 3), "drift"), 2);
  EXPECT_EQ(seriesOf(times, values, 1 + 1e-12, 3 - 1e-12).times.size(), 2u);  // round-off
  EXPECT_TRUE(std::isnan(statisticOf(seriesOf(times, values, 1.5, 2.5), "mean")));
}

TEST(Statistics, EmptyCellsDoNotCount) {
  const Series s = whole({none, 2, none, 5});
  EXPECT_EQ(statisticOf(s, "mean"), 3.5);
  EXPECT_EQ(valueAt(s, 2.5), 3.5);
  EXPECT_TRUE(std::isnan(valueAt(s, 0.5)));
  for (const char* name : {"last", "min", "max", "mean", "mean_abs", "drift", "relative_drift"})
    EXPECT_TRUE(std::isnan(statisticOf(whole({none, none, none, none}), name))) << name;
}

TEST(Statistics, ValuesAreLinearBetweenRows) {
  const Series s = whole({1, 5, 3, 9});
  EXPECT_EQ(valueAt(s, 0), 1);
  EXPECT_EQ(valueAt(s, 0.25), 2);
  EXPECT_EQ(valueAt(s, 2), 4);
  EXPECT_EQ(valueAt(s, 4), 9);
  EXPECT_EQ(valueAt(s, 4 + 1e-12), 9);  // round-off of the end
  EXPECT_TRUE(std::isnan(valueAt(s, 4.1)));
  EXPECT_TRUE(std::isnan(valueAt(s, -0.1)));
}

}  // namespace
}  // namespace plenum
