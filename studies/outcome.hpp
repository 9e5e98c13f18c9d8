// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

/// What one entry of the case's [[validate]] came to.
struct Validated {
  std::string quantity, statistic, unit, verdict;
  std::optional<double> measured, expected;
};

/// What a run took. Seconds are those of plenum-sph.
struct RunCost {
  double cpuSeconds = 0;               ///< of all threads
  double stepCpuSeconds = 0;           ///< of them, in steps: without measures and files
  double wallSeconds = 0;              ///< by the clock on the wall
  double stepWallSeconds = 0;          ///< of them, in steps
  std::optional<double> instructions;  ///< where the machine counts them
  double peakBytes = 0;                ///< of memory
  double updatesPerSecond = 0;         ///< fluid particles moved by one step
  double interactionsPerSecond = 0;    ///< neighbours in the support of those
};

/// What a run came to. A run that failed is a result, too.
struct RunOutcome {
  std::string failure;                    ///< why it ended early, one line; empty: it did not
  std::optional<double> failureTime;      ///< in the run's own time [s]
  std::map<std::string, double> figures;  ///< of the last state, as in summary.json
  std::vector<Validated> validation;
  long steps = 0;
  long fluidParticles = 0, wallParticles = 0;
  RunCost cost;
  std::filesystem::path folder;  ///< its history.csv, last.png, validation.json, ...

  bool hasFailed() const { return !failure.empty(); }

  /// A figure of the last state; NaN where there is none.
  double figure(const std::string& name) const;
};

/// What plenum-sph wrote into `folder`, as far as it came: nothing is missed where a run failed
/// before.
void readResults(const std::filesystem::path& folder, RunOutcome& outcome);

/// An outcome is kept beside its files, written last: a folder without it is of a run that was
/// killed. Throws RunError if it cannot be written.
void keepOutcome(const RunOutcome& outcome);
/// None where `folder` keeps none that can be read.
std::optional<RunOutcome> keptOutcome(const std::filesystem::path& folder);

/// A column of a run's history.csv, named without its unit. Empty cells are left out.
struct HistoryColumn {
  std::vector<double> times, values;  ///< [s], and in the column's unit
};

/// Throws InputError that lists the columns if `name` is none of them.
HistoryColumn historyOf(const RunOutcome& outcome, const std::string& name);

}  // namespace plenum::study
