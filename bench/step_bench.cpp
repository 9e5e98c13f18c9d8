// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a whole step costs, search and sorting included, and the share of its parts:
//   plenum-bench [PARTICLES [THREADS]]
#include "bench/scenes.hpp"
#include "solver/simulation.hpp"

#include <omp.h>

#include <cstdio>
#include <ctime>

namespace plenum::bench {
namespace {

template <int Dim>
void run(bool dam, std::size_t n, const char* precision, int threads, int steps) {
  omp_set_num_threads(threads);
  SolverSettings s = dam ? damBreakSettings(Dim) : quietGasSettings(Dim);
  s.precision = precision;
  Scene<Dim> scene = dam ? damBreak<Dim>(n, 2 * s.smoothingLength) : quietGas<Dim>(n);
  if (dam) scene.info.walls[0].thickness = 100;
  Simulation<Dim> sim(std::move(scene), s);
  for (int k = 0; k < 5; ++k) sim.step(sim.maxTimeStep());
  sim.engine().stopwatch().reset();
  const auto rebuilds = sim.engine().nRebuilds();
  const std::clock_t c = std::clock();
  timespec a, b;
  clock_gettime(CLOCK_MONOTONIC, &a);
  for (int k = 0; k < steps; ++k) sim.step(sim.maxTimeStep());
  const double cpu = double(std::clock() - c) / CLOCKS_PER_SEC;
  clock_gettime(CLOCK_MONOTONIC, &b);
  const double wall = (b.tv_sec - a.tv_sec) + 1e-9 * (b.tv_nsec - a.tv_nsec);
  const double nf = double(sim.particles().nFluid()), na = double(sim.particles().size());
  std::printf(
      "%d-D %s %s n=%.0f+%.0f thr %d: %.2f M fluid/s (%.2f M all/s) wall %.2f; rebuild every %.1f; "
      "bytes %.0f;",
      Dim, dam ? "dam" : "gas", precision, nf, na - nf, threads, nf * steps / cpu * 1e-6,
      na * steps / cpu * 1e-6, nf * steps / wall * 1e-6,
      double(steps) / (sim.engine().nRebuilds() - rebuilds), sim.bytesPerParticle());
  for (int p = 0; p < int(Part::count); ++p)
    std::printf(" %s %.1f", partNames[p].data(),
                sim.engine().stopwatch().seconds(Part(p)) / steps / na * 1e9);
  std::printf(" ns/p\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace plenum::bench

int main(int argc, char** argv) {
  using namespace plenum::bench;
  const std::size_t n = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100000;
  const int t = argc > 2 ? static_cast<int>(std::strtol(argv[2], nullptr, 10)) : 1;
  for (const char* p : {"mixed", "double"})
    for (bool dam : {true, false}) {
      run<2>(dam, n, p, t, 30);
      run<3>(dam, n, p, t, 15);
    }
}
