// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/validate_settings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum {

namespace {

Section<CurveSettings> curveSection() {
  using S = CurveSettings;
  return Section<S>("a course in time that the quantity must follow")
      .list("times", &S::times, "s", Range::any(), "ascending")
      .required()
      .list("values", &S::values, "", Range::any(), "as many, in the quantity's unit")
      .required()
      .condition([](const S& curve, const CaseNode& table, int) {
        if (curve.times.empty()) table.find("times")->fail("must name at least one time");
        if (std::ranges::adjacent_find(curve.times, std::greater_equal{}) != curve.times.end())
          table.find("times")->fail("must ascend");
        if (curve.values.size() != curve.times.size())
          table.find("values")->fail(
              fmt::format("has {} entries for {} times", curve.values.size(), curve.times.size()));
      });
}

void checkStatistic(const ValidateSettings& v, const CaseNode& table, int) {
  const std::string statistic = v.statisticOrDefault();
  const auto refuse = [&](const char* key, const char* message) {
    if (const CaseNode* node = table.find(key)) node->fail(message);
  };
  if (v.curve) refuse("statistic", "a curve is compared at its own times: leave this out");
  if (statistic == "at" && !v.time) table.fail("statistic = \"at\" needs the key 'time' [s]");
  if (statistic != "at") refuse("time", "has a meaning for statistic = \"at\" only");
  const bool isOverRows = !v.curve && statistic != "at" && statistic != "last";
  for (const char* key : {"from", "until"})
    if (!isOverRows) refuse(key, "has a meaning for mean, mean_abs, min, max and drifts only");
  if (v.from && v.until && !(*v.until > *v.from)) refuse("until", "must be after from");
}

void checkBounds(const ValidateSettings& v, const CaseNode& table, int) {
  const bool isBounded = v.atLeast || v.atMost;
  const int nForms = (v.expected ? 1 : 0) + (v.curve ? 1 : 0) + (isBounded ? 1 : 0);
  if (nForms != 1)
    table.fail(
        "must say what is expected in one way: 'expected' or 'curve' with a tolerance, or "
        "'at_least' and 'at_most'");
  if (isBounded) {
    for (const char* key : {"tolerance", "relative_tolerance"})
      if (const CaseNode* node = table.find(key)) node->fail("belongs to 'expected' or 'curve'");
    if (v.atLeast && v.atMost && *v.atLeast > *v.atMost)
      table.find("at_most")->fail("must not be below at_least");
    return;
  }
  if (v.tolerance.has_value() == v.relativeTolerance.has_value())
    table.fail("needs one of 'tolerance' and 'relative_tolerance'");
  const bool hasZero = v.curve ? std::ranges::count(v.curve->values, 0.0) > 0 : *v.expected == 0;
  if (v.relativeTolerance && hasZero)
    table.find("relative_tolerance")->fail("nothing is relative to zero; give 'tolerance'");
}

}  // namespace

const Section<ValidateSettings>& validateSection() {
  using S = ValidateSettings;
  static const Section<S> section =
      Section<S>("what the scene must show; plenum-sph compares and prints it when a run ends")
          .text("quantity", &S::quantity, "a column of history.csv")
          .required()
          .text("statistic", &S::statistic,
                "what is made of the column: its value at a time, in the last row, its mean over "
                "time, that of its absolute value, its least or largest one, or how far it goes "
                "from its first one, as it is or over that; absent: at where there is a time, else last",
                {"at", "last", "mean", "mean_abs", "min", "max", "drift", "relative_drift"})
          .number("time", &S::time, "s", Range::any(), "of at; the run has a row exactly there")
          .number("from", &S::from, "s", Range::any(), "rows before do not count; absent: all")
          .number("until", &S::until, "s", Range::any(), "rows after do not count; absent: all")
          .number("expected", &S::expected, "", Range::any(), "the value, in the quantity's unit")
          .number(
              "tolerance", &S::tolerance, "", Range::notNegative(),
              "how far measured and expected may differ, with a curve in the mean of its points")
          .number("relative_tolerance", &S::relativeTolerance, "", Range::notNegative(),
                  "the same as a share of the expected value, point by point of a curve")
          .number("at_least", &S::atLeast, "", Range::any(), "lower bound")
          .number("at_most", &S::atMost, "", Range::any(), "upper bound")
          .section("curve", &S::curve, curveSection())
          .text("source", &S::source, "where the expectation comes from, for the table")
          .condition(checkStatistic)
          .condition(checkBounds);
  return section;
}

}  // namespace plenum
