// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study accuracy: a case over a grid of settings, as charts, a table and advice.
#pragma once

#include "studies/study.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace plenum::study {

struct AccuracyOptions {
  std::filesystem::path caseFile;
  std::vector<std::string> vary;      ///< as Variation::parse reads them
  std::vector<std::string> settings;  ///< "key=value" of all runs
  bool quick = false;
  std::string quantity;        ///< "": the case's first
  bool isAgainstCase = false;  ///< errors are relative differences from the case's own run
  std::vector<double> within;  ///< errors to advise on
  std::vector<std::pair<std::string, std::string>> comparisons;  ///< of settings at equal error
  std::filesystem::path folder;
  std::filesystem::path programs;
  int jobs = 1;
  int repeats = 1;  ///< of each run; the one that takes least counts
  bool quiet = false;
};

/// The error that is asked for; runs the case itself where that says what is right.
ErrorMeasure measureFor(const AccuracyOptions& options, const CaseSettings& settings,
                        RunStore& store);

/// Runs what is not there yet. Throws InputError, before anything runs, for settings that cannot be
/// used and quantities that cannot be validated.
Study runAccuracy(const AccuracyOptions& options);

/// Sentences for people: failures, advice and comparisons.
std::vector<std::string> sentencesOf(const Study& study, const AccuracyOptions& options);

/// results.csv, charts and report.html in the study's folder.
void writeAccuracy(const Study& study, const AccuracyOptions& options);

/// A line a run, for the terminal.
std::string tableOf(const Study& study);

}  // namespace plenum::study
