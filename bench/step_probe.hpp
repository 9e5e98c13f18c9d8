// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/case.hpp"
#include "solver/interactions.hpp"
#include "engine/stopwatch.hpp"

#include <functional>

namespace plenum::bench {

struct Request {
  int threads = 1;
  double seconds = 0;      ///< least time of a measurement
  double mostSeconds = 0;  ///< after which it ends before the next search, too
};

/// What a step costs, its share of the search and sort before it included.
struct Measurement {
  double seconds = 0;      ///< a step: CPU time of one thread, wall time of more
  double wallSeconds = 0;  ///< a step
  double cpuSeconds = 0;   ///< a step, of all threads
  double partSeconds[static_cast<int>(Part::count)]{};  ///< a step, wall time
  double stepsPerRebuild = 0;
  double nSteps = 0;  ///< that were timed
  double nFluid = 0, nWalls = 0;
  Interactions interactions;  ///< of a step, mean of before and after
  double countedBytes = 0;    ///< Simulation::bytesPerParticle()
  double processBytes = 0;    ///< a particle; 0: not known
  bool isRunning = false;     ///< a dam break that was really run

  double n() const { return nFluid + nWalls; }
};

/// Sets up a case and returns what measures it. The state that it begins from is the running dam
/// break if isReallyRun().
std::function<Measurement(const Request&)> stepProbe(const Case& c, const Choice& choice);

}  // namespace plenum::bench
