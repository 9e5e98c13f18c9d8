// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/outcome.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum::study {
namespace {

TEST(Outcome, IsKeptWithAllItsBits) {
  const test::TemporaryFolder folder;
  RunOutcome outcome;
  outcome.failure = "particle 3: too fast";
  outcome.failureTime = 0.1 + 0.2;
  outcome.figures = {{"f.5", 1.0 / 3}};
  outcome.validation = {{"front", "at", "m", "ok", 1.0 / 7, {}}};
  outcome.steps = 12;
  outcome.fluidParticles = 5;
  outcome.cost.stepCpuSeconds = 1.0 / 9;
  outcome.cost.stepWallSeconds = 1.0 / 11;
  outcome.folder = folder.path();
  keepOutcome(outcome);
  const auto kept = keptOutcome(folder.path());
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept->hasFailed());
  EXPECT_EQ(kept->failureTime, outcome.failureTime);
  EXPECT_EQ(kept->figure("f.5"), 1.0 / 3);
  EXPECT_TRUE(std::isnan(kept->figure("f.6")));
  EXPECT_EQ(kept->validation.at(0).measured, 1.0 / 7);
  EXPECT_FALSE(kept->validation.at(0).expected);
  EXPECT_EQ(kept->steps, 12);
  EXPECT_EQ(kept->cost.stepCpuSeconds, 1.0 / 9);
  EXPECT_EQ(kept->cost.stepWallSeconds, 1.0 / 11);
  EXPECT_FALSE(kept->cost.instructions);
}

TEST(Outcome, IsNoneWhereARunWasKilled) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(keptOutcome(folder.path()));
  writeTextFile(folder / "outcome.json", "{\"failure\": \"\", \"figu");
  EXPECT_FALSE(keptOutcome(folder.path()));
  writeTextFile(folder / "outcome.json", "{\"failure\": \"\"}");
  EXPECT_FALSE(keptOutcome(folder.path()));
}

TEST(Outcome, ReadsWhatARunWrote) {
  const test::TemporaryFolder folder;
  writeTextFile(folder / "summary.json", R"({"steps": 10, "fluid_particles": 4,
    "wall_particles": 2, "updates_per_second": 100.0, "neighbours_mean": 20.0,
    "measures": {"f.5": 0.25, "psi6": null},
    "activity_seconds": {"stepping": 1.0, "measuring": 2.0, "writing": 1.0},
    "activity_cpu_seconds": {"stepping": 2.0, "measuring": 4.0, "writing": 0.5}})");
  RunOutcome outcome;
  readResults(folder.path(), outcome);
  EXPECT_EQ(outcome.cost.stepCpuSeconds, 2);
  EXPECT_EQ(outcome.cost.stepWallSeconds, 1);
  EXPECT_EQ(outcome.cost.interactionsPerSecond, 2000);
  EXPECT_EQ(outcome.figure("f.5"), 0.25);
  EXPECT_TRUE(std::isnan(outcome.figure("psi6")));
}

TEST(Outcome, HasColumnsOfItsHistory) {
  const test::TemporaryFolder folder;
  writeTextFile(folder / "history.csv", "time [s],f.5,speed [m/s]\n0,1,\n0.5,2,3\n");
  RunOutcome outcome;
  outcome.folder = folder.path();
  const HistoryColumn speed = historyOf(outcome, "speed");
  EXPECT_EQ(speed.times, std::vector<double>{0.5});
  EXPECT_EQ(speed.values, std::vector<double>{3});
  EXPECT_EQ(historyOf(outcome, "f.5").values, (std::vector<double>{1, 2}));
  EXPECT_THROW(historyOf(outcome, "f.6"), InputError);
}

}  // namespace
}  // namespace plenum::study
