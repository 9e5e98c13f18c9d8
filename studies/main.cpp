// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study: what accuracy costs, and where methods become unstable.
#include "particles/command_line.hpp"
#include "particles/version.hpp"
#include "studies/commands.hpp"

#include <unistd.h>

#include <csignal>

namespace plenum::study {

namespace {

constexpr const char* examples = R"(
Examples:
  plenum-study accuracy cases/hydrostatic_tank.toml --vary kernel=convex,wendland_c2 --vary h=1.5,2
  plenum-study minimal cases/sod.toml --error 0.02
  plenum-study stability pairing --kernels convex,wendland_c2_1d

Exit code: 0 done, 1 the input is at fault, 2 failure. A run of a study that fails is a result.)";

constexpr const char* stabilityExamples = R"(
Examples, from theory to measurement:
  plenum-study stability transforms
  plenum-study stability modes --lattice fcc --smoothing-length 1.2,1.5 --background-pressure 0.1
  plenum-study stability growth --kernels convex
  plenum-study stability pairing --start noise --kernels cubic_spline,wendland_c2)";

/// Throws InputError that lists the maps where `stability` stands without one.
void requireMap(const CLI::App& stability) {
  if (!stability.parsed() || !stability.get_subcommands().empty()) return;
  std::vector<std::string> names;
  for (const CLI::App* command : stability.get_subcommands({}))
    names.push_back(command->get_name());
  const std::vector<std::string> unknown = stability.remaining();
  throw InputError(
      fmt::format("stability: {}; there are {}, see stability --help",
                  unknown.empty() ? "no map given" : "unknown map '" + unknown.front() + "'",
                  fmt::join(names, ", ")));
}

/// Runs end with the study; finished ones are kept.
extern "C" void sayHowToGoOn(int signal) {
  constexpr char text[] =
      "\nplenum-study: interrupted; begin it again with the same folder, and it goes on from "
      "here\n";
  if (write(STDERR_FILENO, text, sizeof text - 1) < 0) _exit(128 + signal);
  _exit(128 + signal);
}

int main(int argc, char** argv) {
  std::signal(SIGINT, sayHowToGoOn);
  std::signal(SIGTERM, sayHowToGoOn);
  CLI::App app{"plenum-study: charts speed against accuracy, and where methods fail"};
  app.footer(examples);
  app.set_version_flag("--version", fmt::format("plenum-study {}", version));
  std::vector<Command> commands{addAccuracy(app), addMinimal(app)};
  CLI::App* stability = app.add_subcommand("stability", "where methods become unstable");
  stability->require_subcommand(0, 1);
  stability->allow_extras();  // so that requireMap can say what was not understood
  stability->footer(stabilityExamples);
  for (const auto& add : {addLatticeCommands, addMapCommands})
    for (Command& command : add(*stability)) commands.push_back(std::move(command));
  if (const auto code = parseCommandLine(app, argc, argv)) return *code;
  requireMap(*stability);
  for (const Command& command : commands)
    if (command.app->parsed()) return command.run();
  return exitOk;
}

}  // namespace

}  // namespace plenum::study

int main(int argc, char** argv) {
  return plenum::runProgram("plenum-study", [&] { return plenum::study::main(argc, argv); });
}
