// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a whole step costs on one core, sorting and search included, in a gas that moves: the
// particles start on a jittered lattice with random velocities of a tenth of the sound speed.
//   build/release/bench/plenum-bench --benchmark_repetitions=5
#include "solver/simulation.hpp"
#include "tests/support/jittered_scene.hpp"

#include <benchmark/benchmark.h>
#include <omp.h>

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
  for (auto _ : state) simulation.step(dt);

  const auto n = static_cast<double>(simulation.particles().size());
  const auto interactions = static_cast<double>(countInteractions(simulation));
  const auto nSteps = static_cast<double>(state.iterations());
  using benchmark::Counter;
  state.counters["updates_per_s"] = Counter(n * nSteps, Counter::kIsRate);
  state.counters["ns_per_interaction"] =
      Counter(interactions * nSteps * 1e-9, Counter::kIsRate | Counter::kInvert);
  state.counters["neighbours"] = interactions / n;
  state.counters["steps_per_search"] =
      nSteps / static_cast<double>(simulation.engine().nRebuilds() - rebuilds);
  state.counters["bytes_per_particle"] = simulation.bytesPerParticle();
}

void register2d() {
  for (const char* density : {"summation", "continuity"}) {
    const std::string name = std::string("whole_step/2-D/") + density;
    benchmark::RegisterBenchmark(name.c_str(), wholeStep<2>, density)
        ->Unit(benchmark::kMillisecond);
  }
}

void register3d() {
  for (const char* density : {"summation", "continuity"}) {
    const std::string name = std::string("whole_step/3-D/") + density;
    benchmark::RegisterBenchmark(name.c_str(), wholeStep<3>, density)
        ->Unit(benchmark::kMillisecond);
  }
}

const bool registered = [] {
  register2d();
  register3d();
  return true;
}();

}  // namespace
}  // namespace plenum
