// SPDX-License-Identifier: GPL-3.0-or-later
//
// A grid of runs of one case, with the error and the cost of each.
#pragma once

#include "studies/error_measure.hpp"
#include "studies/front.hpp"
#include "studies/variation.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

struct StudyRow {
  std::vector<std::size_t> at;  ///< value of each axis
  std::string name;             ///< the values, for people
  RunOutcome outcome;
  std::optional<double> error;  ///< by the study's measure; none if the run failed
};

struct Study {
  std::filesystem::path caseFile;
  CaseSettings settings;  ///< of the case, without what is varied
  std::vector<Variation> axes;
  ErrorMeasure measure;
  std::string unit;  ///< of the error, "" if it has none
  std::vector<StudyRow> rows;

  /// Time of a run's steps [s]: CPU time, or time by the clock where the number of threads is
  /// varied, which costs CPU time to save that.
  double costOf(const RunOutcome& outcome) const;
  double costOf(const StudyRow& row) const { return costOf(row.outcome); }
  bool isTimedByClock() const;
  /// Of outcomes of the same settings the one that costs least: other programs can only make a run
  /// take longer. Failures come last.
  const RunOutcome& leastOf(const std::vector<RunOutcome>& outcomes) const;

  /// Places of the rows that have an error, and their cost and error.
  std::vector<std::size_t> measuredRows() const;
  std::vector<CostAndError> pointsOf(const std::vector<std::size_t>& which) const;
  /// Places of the rows on the Pareto front, by rising cost; without those whose error is less than
  /// a hundredth better than that of a cheaper one.
  std::vector<std::size_t> front() const;
  std::vector<std::size_t> wholeFront() const;  ///< with those
  /// An error with its unit: "1.18 %".
  std::string printed(double error) const;
};

/// The unit of the study's errors, as its runs have it; none where they are relative.
std::string unitOf(const Study& study);

/// Rows as comma separated values: axes, error, every figure of [[validate]], cost, memory,
/// failure.
std::string csvOf(const Study& study);

/// What the study says, a sentence each: the cheapest setting within each of `errors` and what
/// paying more buys; with none given, within 1, 2 or 5 times a power of ten in the middle of the
/// front.
std::vector<std::string> adviceOf(const Study& study, std::vector<double> errors);

/// Which of two settings, each given as values "kernel=convex" of axes, is cheaper at equal error.
/// Each stands for the row that has its values; it is compared with what the other costs at its
/// error, between that other's rows along the numeric axes that are given for it. Throws InputError
/// for values that are not in the study.
std::string comparisonOf(const Study& study, const std::string& one, const std::string& other);
/// Throws that InputError.
void requireComparable(const Study& study, const std::string& one, const std::string& other);

}  // namespace plenum::study
