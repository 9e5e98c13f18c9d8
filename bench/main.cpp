// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-bench: what a step costs. docs/benchmarks.md explains the columns.
#include "bench/suite.hpp"
#include "bench/table.hpp"
#include "particles/command_line.hpp"
#include "particles/errors.hpp"
#include "particles/version.hpp"

#include <omp.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <regex>

namespace plenum::bench {

namespace {

const char* const description =
    R"(plenum-bench measures what a whole step costs, sorting and search included.

  plenum-bench                                  1e4 to 1e6 particles, some minutes
  plenum-bench --largest 1e7 --filter dam_break three gigabytes and more
  plenum-bench --largest 1e5 --threads 1 --dimensions 3 --precisions mixed
  plenum-bench --scenes ideal_gas --threads 1 --smallest 1e5 --largest 1e5

Scenes: dam_break (continuity, pressure, Monaghan's viscosity, walls that carry
density) and quiet_gas (density by summation, pressure, viscosity, periodic);
wendland_c2 with 33 neighbours in 2-D and about 97 in 3-D. ideal_gas (smoothing
lengths by iteration, grad-h forces, energy equation, viscosity, kick-drift-kick,
periodic): 23 and 57.
Dam breaks of up to 1e5 particles are run from rest until the column has
collapsed (once; the state is kept in the folder --states), larger ones are made
to look like that (*).

ns/interaction  the time of a step over the number of true interactions: pairs
                closer than the kernel's support, both directions, each counted
                once a step however many passes there are. A term of the engine
                counts them before and after. CPU time with one thread, wall
                time with more; median of the repetitions, +- half their range.
cores           CPU time over wall time; ! where threads had to wait for other
                programs.
M particles/s   particles that a step moves on per second, in millions: "all"
                counts the walls, too, which carry density and pressure here.
steps/sort      steps from one sorting and search to the next.
share           of the wall time of a step, by the engine's stopwatch.
% of peak       what the pair loops do of use (dam break: 32.5 operations an
                interaction in 2-D, 40 in 3-D; bench/flops.hpp) over what as many threads
                reach with multiply-adds alone, measured in turn with the steps.
bytes/particle  what the program counts, and what its process takes (from 1e6
                particles on).

The repetitions of all cases of a size take turns, so that a busy machine
spoils none of them alone; each case has a process of its own.)";

int main(int argc, char** argv) {
  Choice choice;
  const int cores = omp_get_num_procs();
  choice.threads = {1};
  if (cores > 1) choice.threads.push_back(std::min(cores, 2));
  CLI::App app(description);
  app.set_version_flag("--version", fmt::format("plenum-bench {}", version));
  app.add_option("--smallest", choice.smallest, "particles of the smallest cases [1e4]")
      ->check(CLI::Range(1e3, 1e9));
  app.add_option("--largest", choice.largest, "and of the largest, in powers of ten [1e6]")
      ->check(CLI::Range(1e3, 1e9));
  app.add_option("--scenes", choice.scenes, "dam_break, quiet_gas, ideal_gas [all]")
      ->delimiter(',')
      ->check(CLI::IsMember({"dam_break", "quiet_gas", "ideal_gas"}));
  app.add_option("--dimensions", choice.dimensions, "2, 3 [both]")
      ->delimiter(',')
      ->check(CLI::IsMember({2, 3}));
  app.add_option("--precisions", choice.precisions, "mixed, double [both, double up to 1e5]")
      ->delimiter(',')
      ->check(CLI::IsMember({"mixed", "double"}));
  app.add_option("--threads", choice.threads, "numbers of threads [1,2]")
      ->delimiter(',')
      ->check(CLI::Range(1, cores));
  app.add_flag("--full", choice.full, "double from 1e6 particles on, too");
  app.add_option("--running", choice.running,
                 "most particles whose dam break is really run; 0: none [1e5]")
      ->check(CLI::Range(0.0, 1e9));
  app.add_option("--filter", choice.filter,
                 "regular expression of names like dam_break/2d/mixed/n:100000");
  app.add_option("--repetitions", choice.repetitions, "of each case [5; 3 from 1e6 on]")
      ->check(CLI::Range(1, 1000));
  app.add_option("--seconds", choice.seconds, "least time of a repetition [0.25]")
      ->check(CLI::Range(0.001, 1000.0));
  app.add_option("--json", choice.json, "write all repetitions there, as Google Benchmark does")
      ->take_last();
  app.add_option("--states", choice.states, "folder of running dam breaks [out/bench]")
      ->take_last();
  if (const auto done = parseOptions(app, argc, argv)) return *done;
  if (choice.smallest > choice.largest)
    throw InputError(fmt::format("--smallest {:g} is more than --largest {:g}", choice.smallest,
                                 choice.largest));
  try {
    std::regex(choice.filter);
  } catch (const std::regex_error&) {
    throw InputError(fmt::format("--filter {}: not a regular expression", choice.filter));
  }
  if (!choice.json.empty()) {
    const auto folder = std::filesystem::path(choice.json).parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder))
      throw InputError(fmt::format("--json {}: there is no such folder", choice.json));
  }
  Suite suite(choice);
  suite.run();
  std::cout << tableOf(suite.runs());
  if (!choice.json.empty()) suite.writeJson(choice.json);
  return exitOk;
}

}  // namespace

}  // namespace plenum::bench

int main(int argc, char** argv) {
  return plenum::runProgram("plenum-bench", [&] { return plenum::bench::main(argc, argv); });
}
