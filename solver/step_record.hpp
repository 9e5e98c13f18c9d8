// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace plenum {

/// What a run hands from step to step beside its particles.
struct StepRecord {
  long nSteps = 0;
  double runStart = 0;             ///< time of the first state [s]
  double largestAcceleration = 0;  ///< of a fluid particle in the last step [m/s^2]
  double fastest = 0;              ///< fluid particle [m/s]
  double largestRate = 0;          ///< at which a gas particle changes [1/s]

  /// For files that a run goes on from.
  std::vector<std::pair<std::string, double>> progress() const;
  /// Throws InputError if a figure is missing.
  void restore(const std::vector<std::pair<std::string, double>>& progress);
};

}  // namespace plenum
