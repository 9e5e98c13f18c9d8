// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-count-steps STEPS: runs a small dam break for a counter of instructions
// (tests/unit/bench/instruction_count_test.sh) and prints what the counts are to be divided by.
#include "solver/interactions.hpp"
#include "bench/scenes.hpp"
#include "engine/instruction_set.hpp"
#include "particles/errors.hpp"
#include "solver/simulation.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <cstdio>
#include <cstdlib>

namespace plenum::bench {

namespace {

int main(int argc, char** argv) {
  const long nSteps = argc == 2 ? std::strtol(argv[1], nullptr, 10) : 0;
  if (nSteps < 1 || nSteps > 100000)
    throw InputError("usage: plenum-count-steps STEPS, with 1 to 100000 steps");
  omp_set_num_threads(1);
  Setup<2> setup = damBreakMade<2>(2000);
  Simulation<2> sim(std::move(setup.scene), setup.settings);
  for (long k = 0; k < nSteps; ++k) sim.step(sim.maxTimeStep());
  const Interactions count = countInteractions(sim.engine(), sim.particles(), true);
  std::fputs(fmt::format("{:.0f} interactions a step; {} particles; {}\n", count.all,
                         sim.particles().size(), nameOf(instructionSet()))
                 .c_str(),
             stdout);
  return exitOk;
}

}  // namespace

}  // namespace plenum::bench

int main(int argc, char** argv) {
  return plenum::runProgram("plenum-count-steps", [&] { return plenum::bench::main(argc, argv); });
}
