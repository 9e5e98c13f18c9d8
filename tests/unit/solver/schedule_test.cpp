// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/schedule.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace plenum {
namespace {

std::vector<double> timesOf(Schedule schedule) {
  std::vector<double> times;
  while (times.size() < 100 && schedule.isDue(1e9)) {
    times.push_back(schedule.next());
    schedule.advance();
  }
  return times;
}

TEST(Schedule, EndsWithTheEndWhetherOrNotItIsAMultiple) {
  EXPECT_EQ(timesOf({0, 0.5, 2}), (std::vector{0.5, 1.0, 1.5, 2.0}));
  EXPECT_EQ(timesOf({0, 0.75, 2}), (std::vector{0.75, 1.5, 2.0}));
  EXPECT_EQ(timesOf({1, 5, 2}), (std::vector{2.0}));
}

TEST(Schedule, RoundOffMakesNoExtraTime) {
  const auto times = timesOf({0, 0.1, 0.1 * 3});  // 0.1 * 3 is a little more than 0.3
  EXPECT_EQ(times.size(), 3u);
  EXPECT_EQ(times.back(), 0.1 * 3);
}

TEST(Schedule, ExtraTimesComeBetweenTheRegularOnes) {
  EXPECT_EQ(timesOf({0, 0.5, 2, {0.2, 0.7, 0.8}}),
            (std::vector{0.2, 0.5, 0.7, 0.8, 1.0, 1.5, 2.0}));
  // Before the start, after the end and on regular times they add nothing; round-off does not
  // matter: 3 * 0.1 is a little more than 0.3.
  EXPECT_EQ(timesOf({1, 0.5, 2, {0.5, 1, 1.5, 2, 3}}), (std::vector{1.5, 2.0}));
  EXPECT_EQ(timesOf({0, 0.1, 0.4, {0.3}}), (std::vector{0.1, 0.2, 3 * 0.1, 0.4}));
}

}  // namespace
}  // namespace plenum
