// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/error_measure.hpp"

#include "particles/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plenum::study {
namespace {

CaseSettings settingsWith(const std::string& validations) {
  return readCase(CaseNode::parse(
      "title = \"t\"\ndimension = 2\nspacing = 1\n[[fluid]]\nregion = \"all\"\n" + validations,
      "case.toml"));
}

constexpr const char* someEntries = R"(
[[validate]]
quantity = "max_speed"
at_most = 1
[[validate]]
quantity = "front"
time = 2
expected = 4.0
relative_tolerance = 0.1
[[validate]]
quantity = "pressure_gradient_error"
statistic = "mean_abs"
expected = 1.32
tolerance = 0.05
[[validate]]
quantity = "energy_total"
statistic = "relative_drift"
at_most = 1e-3
)";

RunOutcome outcomeWith(double measured) {
  RunOutcome outcome;
  outcome.validation = {{"max_speed", "last", "", "ok", 3, {}},
                        {"front", "at", "m", "ok", measured, 4.0},
                        {"pressure_gradient_error", "mean_abs", "%", "ok", measured, 1.32},
                        {"energy_total", "relative_drift", "", "ok", measured, {}}};
  return outcome;
}

TEST(ErrorMeasure, IsOfEntriesThatAreErrorsOrExpectSomething) {
  const auto measures = errorMeasuresOf(settingsWith(someEntries));
  ASSERT_EQ(measures.size(), 3u);  // not the bound of max_speed
  EXPECT_EQ(measures[0].name(), "front");
  EXPECT_NEAR(measures[0].of(outcomeWith(3)).value(), 0.25, 1e-15);  // relative, as its tolerance
  EXPECT_EQ(measures[1].name(), "pressure_gradient_error (mean_abs)");
  EXPECT_EQ(measures[1].of(outcomeWith(-1.5)), 1.5);  // an error by itself, not against 1.32
  EXPECT_EQ(measures[2].of(outcomeWith(1e-4)), 1e-4);
}

TEST(ErrorMeasure, MayBeADifferenceFromTheCaseItself) {
  const CaseSettings settings = settingsWith(someEntries);
  ErrorMeasure measure = measureAgainstCase(settings, "max_speed");  // which has a bound only
  RunOutcome itself = outcomeWith(0), other = outcomeWith(0);
  itself.validation[0].measured = 4;
  takeReference(measure, itself);
  EXPECT_EQ(measure.of(itself), 0);
  EXPECT_EQ(measure.of(other), 0.25);  // 3 instead of 4
  itself.validation[0].measured = 0;
  EXPECT_THROW(takeReference(measure, itself), RunError);
  itself.failure = "too fast";
  EXPECT_THROW(takeReference(measure, itself), RunError);
  EXPECT_THROW(measureAgainstCase(settings, "temperature"), InputError);
}

TEST(ErrorMeasure, HasNoValueWhereARunFailed) {
  const ErrorMeasure measure = errorMeasuresOf(settingsWith(someEntries))[0];
  RunOutcome failed = outcomeWith(3);
  failed.failure = "too fast";
  EXPECT_FALSE(measure.of(failed));
  EXPECT_FALSE(measure.of(RunOutcome{}));
}

TEST(ErrorMeasure, IsNamedByQuantityAndStatistic) {
  const CaseSettings settings = settingsWith(someEntries);
  EXPECT_EQ(errorMeasureNamed(settings, "").entry, 1u);
  EXPECT_EQ(errorMeasureNamed(settings, "energy_total").entry, 3u);
  EXPECT_EQ(errorMeasureNamed(settings, "pressure_gradient_error:mean_abs").entry, 2u);
  try {
    errorMeasureNamed(settings, "max_speed");
    FAIL() << "max_speed has a bound only";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("front:at, pressure_gradient_error:mean_abs, "
                                                 "energy_total:relative_drift"));
  }
  EXPECT_THROW(errorMeasureNamed(settingsWith(""), ""), InputError);
}

}  // namespace
}  // namespace plenum::study
