// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/errors.hpp"
#include "studies/study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plenum::study {
namespace {

using testing::HasSubstr;

/// Two kernels at two lengths each, with cost and error.
Study someStudy() {
  Study study;
  study.axes = {{{"kernel"}, {"solver.kernel"}, {{"convex"}, {"cubic_spline"}}},
                {{"h"}, {"solver.smoothing_length"}, {{"1"}, {"2"}}}};
  study.unit = "%";
  const auto add = [&](std::vector<std::size_t> at, double cost, std::optional<double> error) {
    StudyRow row{at, describe(study.axes, at), {}, error};
    row.outcome.cost.stepCpuSeconds = cost;
    if (!error) row.outcome.failure = "too fast, at t = 1 s";
    study.rows.push_back(row);
  };
  add({0, 0}, 1, 4);
  add({0, 1}, 4, 1);
  add({1, 0}, 1.5, 2);
  add({1, 1}, 12, 0.5);
  return study;
}

TEST(Advice, NamesTheCheapestAndWhatMoreBuys) {
  const auto sentences = adviceOf(someStudy(), {2.5, 0.6, 0.1});
  ASSERT_EQ(sentences.size(), 3u);
  EXPECT_EQ(sentences[0],
            "The cheapest setting within 2.5 %: cubic_spline, h = 1 d_ref: 2 %, 1.5 s; paying 2.7 "
            "times as much buys 1 % (convex, h = 2 d_ref, 4 s).");
  EXPECT_THAT(sentences[1], HasSubstr("no dearer setting of this study is more accurate"));
  EXPECT_EQ(sentences[2],
            "No run of this study is within 0.1 %; the best is 0.5 %: cubic_spline, h = 2 "
            "d_ref.");
}

// The front of charts leaves out what is less than a hundredth better than something cheaper.
TEST(Advice, KnowsSettingsThatChartsLeaveOut) {
  Study study = someStudy();
  study.rows.resize(3);
  const double costs[] = {1, 1.1, 10}, errors[] = {1.005, 0.999, 0.5};
  for (std::size_t k = 0; k < 3; ++k) {
    study.rows[k].outcome.cost.stepCpuSeconds = costs[k];
    study.rows[k].error = errors[k];
  }
  EXPECT_EQ(study.front().size(), 2u);
  EXPECT_THAT(adviceOf(study, {1}).at(0), HasSubstr("0.999 %, 1.1 s"));
}

TEST(Advice, ChoosesARoundErrorThatIsReached) {
  EXPECT_THAT(adviceOf(someStudy(), {}).at(0), HasSubstr("within 1 %"));
}

// Runs that do what the case does, where the case itself is the measure.
TEST(Advice, KnowsRunsWithoutError) {
  Study study = someStudy();
  study.rows[0].error = 0;
  EXPECT_THAT(adviceOf(study, {}).at(0), HasSubstr("without any error"));
  EXPECT_THAT(adviceOf(study, {0.5}).at(0), HasSubstr("within 0.5 %: convex, h = 1 d_ref: 0 %"));
}

TEST(Study, CountsTheClockWhereThreadsAreVaried) {
  Study study = someStudy();
  study.rows[0].outcome.cost.stepWallSeconds = 7;
  EXPECT_EQ(study.costOf(study.rows[0]), 1);
  study.axes.push_back({{"threads"}, {"threads"}, {{"1"}, {"2"}}});
  EXPECT_EQ(study.costOf(study.rows[0]), 7);
}

TEST(Study, TakesTheLeastOfRepeatsThatEnded) {
  const auto outcomeOf = [](double seconds, const char* failure) {
    RunOutcome outcome;
    outcome.cost.stepCpuSeconds = seconds;
    outcome.failure = failure;
    return outcome;
  };
  const std::vector<RunOutcome> outcomes{outcomeOf(3, ""), outcomeOf(2, ""), outcomeOf(1, "nan")};
  EXPECT_EQ(&someStudy().leastOf(outcomes), &outcomes[1]);
}

TEST(Advice, IsNoneWhereAllFailed) {
  Study study = someStudy();
  for (StudyRow& row : study.rows) row.error.reset();
  EXPECT_THAT(adviceOf(study, {}).at(0), HasSubstr("there is nothing to advise"));
}

/// Along cubic_spline's line, error ~ cost^-2/3 between (1.5, 2) and (12, .5): 1 % costs
/// 1.5 * 8^(1/2) = 4.24 s, 1.06 times the 4 s of convex.
TEST(Comparison, IsAtEqualError) {
  const std::string sentence =
      comparisonOf(someStudy(), "kernel=convex,h=2", "kernel=cubic_spline,h=1");
  EXPECT_THAT(sentence, HasSubstr("1.06 times"));
  EXPECT_THAT(sentence, HasSubstr("convex, h = 2 d_ref is cheaper"));
}

TEST(Comparison, SaysWhereItCannotBeMade) {
  EXPECT_THAT(comparisonOf(someStudy(), "kernel=convex,h=1", "kernel=cubic_spline,h=1"),
              HasSubstr("cannot be compared"));
  EXPECT_THROW(comparisonOf(someStudy(), "kernel=convex", "colour=red"), InputError);
  EXPECT_THROW(comparisonOf(someStudy(), "kernel=convex", "kernel=red"), InputError);
  EXPECT_THROW(comparisonOf(someStudy(), "", "kernel=convex"), InputError);
}

TEST(StudyRows, AreWrittenWithReasonsOfFailures) {
  Study study = someStudy();
  study.rows[1].error.reset();
  study.rows[1].outcome.failure = "too fast, at t = 1 s";
  const std::string text = csvOf(study);
  EXPECT_THAT(text, HasSubstr("kernel,h,"));
  EXPECT_THAT(text, HasSubstr("\"too fast, at t = 1 s\""));
  EXPECT_EQ(std::ranges::count(text, '\n'), 5);
}

}  // namespace
}  // namespace plenum::study
