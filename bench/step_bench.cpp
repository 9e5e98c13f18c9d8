// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a whole step costs on one core, sorting and search included, in a gas that moves: the
// particles start on a jittered lattice with random velocities of a tenth of the sound speed.
//   build/release/bench/plenum-bench --benchmark_repetitions=5
#include "solver/simulation.hpp"
#include "tests/support/jittered_scene.hpp"

#include <benchmark/benchmark.h>
#include <omp.h>

#include <ctime>

namespace plenum {
namespace {

/// Pairs within the support, each counted for both of its particles.
template <int Dim>
std::size_t countInteractions(const Simulation<Dim>& simulation) {
  const auto& engine = simulation.engine();
  const auto x = simulation.particles()[field::position];
  const double supportSquared = engine.support() * engine.support();
  std::size_t n = 0;
  for (const auto& block : engine.neighbours().blocks())
    for (std::size_t i = block.first; i < block.last; ++i)
      for (const auto j : engine.neighbours().allOf(block, i))
        n += normSquared(engine.periodicity().nearestImage(x[i] - x[j])) < supportSquared;
  return n;
}

template <int Dim>
void wholeStep(benchmark::State& state, const std::string& density) {
  omp_set_num_threads(1);
  SolverSettings settings;
  settings.density = density;
  settings.viscosity = ViscositySettings{MonaghanSettings{0.1, 0}};
  const int perAxis = Dim == 2 ? 316 : 46;  // 99,856 and 97,336 particles
  Simulation<Dim> simulation(test::jitteredScene<Dim>(perAxis, true, 0.2, 1.0), settings);
  const double dt = 0.3 * simulation.smoothingLength() / settings.soundSpeed;
  for (int k = 0; k < 3; ++k) simulation.step(dt);
  const std::size_t rebuilds = simulation.engine().nRebuilds();
  const std::clock_t start = std::clock();  // processor time: the machine may be shared
  for (auto _ : state) simulation.step(dt);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;

  const auto n = static_cast<double>(simulation.particles().size());
  const auto interactions = static_cast<double>(countInteractions(simulation));
  const auto nSteps = static_cast<double>(state.iterations());
  state.counters["updates_per_s"] = n * nSteps / seconds;
  state.counters["ns_per_interaction"] = 1e9 * seconds / (interactions * nSteps);
  state.counters["neighbours"] = interactions / n;
  state.counters["searches_per_step"] =
      static_cast<double>(simulation.engine().nRebuilds() - rebuilds) / nSteps;
  state.counters["bytes_per_particle"] = simulation.bytesPerParticle();
}

template <int Dim>
void registerSteps() {
  for (const std::string density : {"summation", "continuity"}) {
    const std::string name = "whole_step/" + std::to_string(Dim) + "-D/" + density;
    benchmark::RegisterBenchmark(name.c_str(), wholeStep<Dim>, density)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(12);
  }
}

const bool registered = (registerSteps<2>(), registerSteps<3>(), true);

}  // namespace
}  // namespace plenum
