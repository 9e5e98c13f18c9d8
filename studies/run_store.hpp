// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of a study: each a case with settings, made by plenum-ic and run by plenum-sph in processes
// of their own, and kept in a folder, so that no run is made twice.
#pragma once

#include "studies/programs.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

struct RunRequest {
  std::filesystem::path caseFile;
  std::vector<std::string> settings;  ///< "key=value", instead of the case's
  int threads = 1;
  bool quick = false;  ///< with the values of the case's table [quick]
};

/// What one entry of the case's [[validate]] came to.
struct Validated {
  std::string quantity, statistic, unit, verdict;
  std::optional<double> measured, expected;
};

/// What a run came to. A run that failed is a result, too.
struct RunOutcome {
  bool isReused = false;              ///< was there before this study asked
  std::string failure;                ///< why it ended early, one line; empty: it came to its end
  std::optional<double> failureTime;  ///< in the run's own time [s]
  double endTime = 0;                 ///< of the last state [s]
  std::map<std::string, double> figures;  ///< of the last state, as in summary.json
  std::vector<Validated> validation;
  long steps = 0;
  long fluidParticles = 0, wallParticles = 0;
  double cpuSeconds = 0;               ///< of plenum-sph, all threads
  double stepCpuSeconds = 0;           ///< of it, in steps: without measures and files
  double wallSeconds = 0;              ///< of plenum-sph
  std::optional<double> instructions;  ///< of plenum-sph, where the machine counts them
  double peakBytes = 0;                ///< of plenum-sph
  double updatesPerSecond = 0;         ///< fluid particles moved one step, a second
  double interactionsPerSecond = 0;    ///< pairs within the support of a fluid particle, a second
  std::filesystem::path folder;        ///< its history.csv, last.png, validation.json, ...

  bool hasFailed() const { return !failure.empty(); }
};

class RunStore {
 public:
  /// Keeps runs in `folder`, in one folder each, named by a key of the case's text with the
  /// settings, the number of threads and the two programs.
  RunStore(std::filesystem::path folder, Programs programs, bool quiet);

  /// The outcomes, in the order of the requests; runs that are there already are not made again.
  /// `jobs` processes at once: one where times count. Shows progress under `label`. Throws
  /// InputError, before anything runs, if settings do not exist or cannot be combined, naming each.
  std::vector<RunOutcome> run(const std::vector<RunRequest>& requests, int jobs,
                              const std::string& label);

  /// Throws InputError that lists every request whose settings plenum-ic or plenum-sph would
  /// refuse.
  void requireUsable(const std::vector<RunRequest>& requests) const;

 private:
  std::filesystem::path folderOf(const RunRequest& request) const;

  std::filesystem::path folder_;
  Programs programs_;
  bool quiet_;
};

/// A column of a run's history.csv, named without its unit, with the times [s]. Empty cells are
/// left out.
struct HistoryColumn {
  std::vector<double> times, values;
};
HistoryColumn historyOf(const RunOutcome& outcome, const std::string& name);

}  // namespace plenum::study
