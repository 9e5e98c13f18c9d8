// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/validation.hpp"

#include "particles/errors.hpp"
#include "solver/validation_report.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

namespace plenum {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

ValidateSettings asked(const std::string& text) {
  return validateSection().read(CaseNode::parse(text, "case.toml"), 2);
}

std::vector<Figure> row(double time, double speed = 0, double height = 0) {
  return {{"time", "s", time}, {"max_speed", "m/s", speed}, {"h1", "m", height}};
}

/// Of a run with rows at 0, 1, 2, 3 s: speeds 0, 2, 4, 6 and heights 1, 2, nothing, 4.
ValidationResult resultOf(const std::string& text) {
  Validation validation({asked(text)}, row(0));
  validation.addRow(row(0, 0, 1));
  validation.addRow(row(1, 2, 2));
  validation.addRow(row(2, 4, none));
  validation.addRow(row(3, 6, 4));
  return validation.evaluate().at(0);
}

const std::string speed = "quantity = \"max_speed\"\n";

TEST(Validation, ExpectedValues) {
  EXPECT_EQ(resultOf(speed + "expected = 6.5\ntolerance = 0.5").verdict, Verdict::ok);
  EXPECT_EQ(resultOf(speed + "expected = 6.5\ntolerance = 0.4").verdict, Verdict::failed);
  EXPECT_EQ(resultOf(speed + "expected = -8\ntolerance = 14").verdict, Verdict::ok);
  EXPECT_EQ(resultOf(speed + "expected = 8\nrelative_tolerance = 0.25").verdict, Verdict::ok);
  EXPECT_EQ(resultOf(speed + "expected = 8\nrelative_tolerance = 0.24").verdict, Verdict::failed);
  EXPECT_EQ(resultOf(speed + "expected = 6\ntolerance = 0").measured, 6);
}

TEST(Validation, Bounds) {
  EXPECT_EQ(resultOf(speed + "at_most = 6").verdict, Verdict::ok);
  EXPECT_EQ(resultOf(speed + "at_most = 5.9").verdict, Verdict::failed);
  EXPECT_EQ(resultOf(speed + "at_least = 6").verdict, Verdict::ok);
  EXPECT_EQ(resultOf(speed + "at_least = 6.1").verdict, Verdict::failed);
  EXPECT_EQ(resultOf(speed + "at_least = 5\nat_most = 7").verdict, Verdict::ok);
  EXPECT_EQ(resultOf(speed + "at_least = 1\nat_most = 2").verdict, Verdict::failed);
}

TEST(Validation, StatisticsAndWindows) {
  EXPECT_EQ(resultOf(speed + "time = 1.5\nat_most = 9").measured, 3);
  EXPECT_EQ(resultOf(speed + "statistic = \"mean\"\nat_most = 9").measured, 3);
  EXPECT_EQ(resultOf(speed + "statistic = \"mean\"\nfrom = 1\nuntil = 2\nat_most = 9").measured, 3);
  EXPECT_EQ(resultOf(speed + "statistic = \"max\"\nuntil = 2\nat_most = 9").measured, 4);
  EXPECT_EQ(resultOf(speed + "statistic = \"drift\"\nfrom = 1\nat_most = 9").measured, 4);
}

TEST(Validation, Curves) {
  const std::string curve = speed + "curve = { times = [0.5, 1, 3], values = [1, 2.5, 5] }\n";
  // Distances 0, 0.5, 1 of values 1, 2.5, 5.
  EXPECT_EQ(resultOf(curve + "tolerance = 0.5").verdict, Verdict::ok);
  EXPECT_EQ(resultOf(curve + "tolerance = 0.49").verdict, Verdict::failed);
  EXPECT_NEAR(*resultOf(curve + "relative_tolerance = 0.1").measured, 0.4 / 3, 1e-15);  // roundings
  EXPECT_EQ(resultOf(curve + "relative_tolerance = 0.14").verdict, Verdict::ok);
  EXPECT_EQ(resultOf(curve + "relative_tolerance = 0.13").verdict, Verdict::failed);
}

TEST(Validation, WhatTheRunDidNotReachIsNoFailure) {
  for (const char* rest : {"time = 3.1\nat_most = 0", "statistic = \"max\"\nuntil = 4\nat_most = 0",
                           "statistic = \"max\"\nfrom = 4\nat_most = 0",
                           "curve = { times = [1, 4], values = [9, 9] }\ntolerance = 0"}) {
    const ValidationResult result = resultOf(speed + rest);
    EXPECT_EQ(result.verdict, Verdict::notReached) << rest;
    EXPECT_FALSE(result.measured.has_value());
    EXPECT_FALSE(allOk({result}));
  }
}

TEST(Validation, EmptyCells) {
  EXPECT_EQ(resultOf("quantity = \"h1\"\ntime = 2\nat_most = 9").verdict, Verdict::noValue);
  EXPECT_EQ(resultOf("quantity = \"h1\"\nstatistic = \"max\"\nfrom = 2\nuntil = 2.5\nat_most = 9")
                .verdict,
            Verdict::noValue);
}

TEST(Validation, RowsOfAResumedRunReplaceThoseFromItsTimeOn) {
  Validation validation({asked(speed + "statistic = \"max\"\nat_most = 3")}, row(0));
  for (const double t : {0.0, 1.0, 2.0, 3.0}) validation.addRow(row(t, t == 2 ? 100 : 1));
  EXPECT_EQ(validation.evaluate()[0].measured, 100);
  validation.addRow(row(2, 3));
  EXPECT_EQ(validation.evaluate()[0].measured, 3);
  validation.addRow(row(2.5, 2));
  EXPECT_EQ(validation.evaluate()[0].verdict, Verdict::ok);
}

TEST(Validation, TheRunHasRowsAtTheTimesThatAreNamed) {
  EXPECT_EQ(Validation::timesOf({asked(speed + "time = 0.3\nat_most = 1"),
                                 asked(speed + "curve = { times = [0.1, 0.3], values = [1, 1] }\n"
                                               "tolerance = 1"),
                                 asked(speed + "statistic = \"mean\"\nfrom = 0.2\nat_most = 1")}),
            (std::vector{0.1, 0.2, 0.3}));
}

TEST(Validation, UnknownColumnsAreRefusedWithTheNearest) {
  try {
    Validation({asked(speed + "at_most = 1"), asked("quantity = \"max_sped\"\nat_most = 1")},
               row(0));
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "validate[1].quantity = \"max_sped\": the run has no such column in history.csv; did "
        "you mean \"max_speed\"?");
  }
}

TEST(ValidationReport, SaysWhatWasAskedAndWhatCameOut) {
  const std::vector<ValidationResult> results{
      resultOf(speed + "expected = 6\ntolerance = 0.5\nsource = \"table 1\""),
      resultOf(speed + "time = 1\nat_most = 1"), resultOf(speed + "time = 9\nat_least = 1")};
  EXPECT_EQ(printed(results),
            "  quantity           expected  measured  verdict      source\n"
            "  last of max_speed  6 +- 0.5  6 m/s     ok           table 1\n"
            "  max_speed at 1 s   <= 1      2 m/s     FAILED\n"
            "  max_speed at 9 s   >= 1      -         not reached\n");
  EXPECT_EQ(printed(std::vector<ValidationResult>{}), "");
  const test::TemporaryFolder folder;
  writeValidation(folder / "validation.json", results);
  std::ostringstream text;
  text << std::ifstream(folder / "validation.json").rdbuf();
  for (const char* part :
       {"\"quantity\": \"max_speed\"", "\"unit\": \"m/s\"", "\"expected\": 6.0",
        "\"measured\": null", "\"verdict\": \"FAILED\"", "\"source\": \"table 1\""})
    EXPECT_NE(text.str().find(part), std::string::npos) << part << text.str();
}

}  // namespace
}  // namespace plenum
