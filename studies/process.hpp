// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

/// How a program ended, and what it took.
struct ProcessEnd {
  int exitCode = 0;
  int signal = 0;         ///< that ended it; 0: none
  double cpuSeconds = 0;  ///< of all its threads
  double wallSeconds = 0;
  double peakBytes = 0;                ///< of resident memory
  std::optional<double> instructions;  ///< outside of the kernel; none where nothing counts them
  std::string errors;                  ///< what it wrote to stderr

  bool isDone() const { return exitCode == 0 && signal == 0; }
};

/// Runs `command`, a program and its arguments, to its end. Its stdout is thrown away. It is killed
/// if this process dies. Throws RunError if it cannot be started.
ProcessEnd runProcess(const std::vector<std::string>& command);

/// Calls work(k) for k = 0 ... n - 1 on `jobs` threads, in this order of beginnings. The first
/// exception ends the rest and is thrown on.
void inParallel(std::size_t n, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace plenum::study
