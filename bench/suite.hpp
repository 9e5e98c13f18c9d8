// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/case.hpp"

#include <benchmark/benchmark.h>

namespace plenum::bench {

/// Names of the counters of a step's run; the parts of a step are counters of their own name
/// (engine/stopwatch.hpp), in percent of the step.
namespace counter {
inline constexpr const char *dimension = "dimension", *threads = "threads_used", *n = "particles",
                            *nFluid = "fluid_particles", *nWalls = "wall_particles",
                            *isRunning = "really_run", *perInteraction = "ns_per_interaction",
                            *perParticle = "ns_per_particle",
                            *interactions = "interactions_per_particle",
                            *millions = "million_particles_per_second",
                            *fluidMillions = "million_fluid_particles_per_second",
                            *stepsPerRebuild = "steps_per_rebuild", *gflops = "pair_loop_gflops",
                            *peak = "fma_peak_gflops", *ofPeak = "pair_loop_percent_of_peak",
                            *countedBytes = "counted_bytes_per_particle",
                            *processBytes = "process_bytes_per_particle", *coresUsed = "cores_used";
}  // namespace counter

/// The runs of all cases, every repetition one. Cases of one size take turns at random.
class Suite {
 public:
  explicit Suite(const Choice& choice);

  /// Throws RunError for the first case that failed.
  void run();

  const std::vector<benchmark::BenchmarkReporter::Run>& runs() const { return runs_; }
  void writeJson(const std::string& path) const;

 private:
  void runTogether(const std::vector<Case>& cases);

  Choice choice_;
  std::vector<benchmark::BenchmarkReporter::Run> runs_;
};

/// Below this share of a core a thread, by the median, other programs took too much of the machine
/// for a wall time to say something (bench/chart.py has the same bound).
inline constexpr double leastShareOfCores = 0.8;

/// A counter of repetitions of one case: their median, or (largest - smallest)/median.
using Runs = std::vector<benchmark::BenchmarkReporter::Run>;
double median(const Runs& runs, const char* counter);
double spreadPercent(const Runs& runs, const char* counter);

}  // namespace plenum::bench
