// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/command_line.hpp"
#include "studies/commands.hpp"
#include "studies/list_option.hpp"
#include "studies/maps/collisions.hpp"
#include "studies/maps/interface.hpp"
#include "studies/maps/pairing.hpp"
#include "studies/maps/tension.hpp"
#include "studies/maps/time_step.hpp"

#include <algorithm>
#include <memory>
#include <thread>

namespace plenum::study {

namespace {

/// The options that all maps have.
void addCommon(CLI::App& command, MapOptions& options) {
  options.jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  command.add_option("-o,--output", options.folder, "folder of tables, charts and runs")
      ->capture_default_str();
  command.add_option("-j,--jobs", options.jobs, "runs at once [all cores]")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--quick", options.quick, "fewer seeds, shorter or coarser runs");
  command.add_option("--programs", options.programs,
                     "folder of plenum-ic and plenum-sph [beside plenum-study]");
  command.add_flag("-q,--quiet", options.quiet, "print what was found only");
}

/// A subcommand `name` whose line `Options` is given to `run`; `declare` adds its own options.
template <class Options, class Declare, class Run>
Command addMap(CLI::App& stability, const char* name, const char* help, const char* footer,
               Declare declare, Run run) {
  CLI::App* command = stability.add_subcommand(name, help);
  command->footer(std::string(footer) +
                  "\n\nAn interrupted map goes on where it stopped: begin it again with the same "
                  "folder.");
  const auto options = std::make_shared<Options>();
  addCommon(*command, options->common);
  declare(*command, *options);
  return {command, [options, run] {
            run(*options);
            return static_cast<int>(exitOk);
          }};
}

Command addPairing(CLI::App& stability) {
  return addMap<PairingOptions>(
      stability, "pairing", "which kernels let particles pair, at which smoothing lengths", R"(
Examples:
  plenum-study stability pairing --quick
  plenum-study stability pairing --start noise --kernels cubic_spline,wendland_c2
  plenum-study stability pairing --dimension 3 --neighbours 48,64,100)",
      [](CLI::App& command, PairingOptions& options) {
        command.add_option("--dimension", options.dimension, "2 or 3")->capture_default_str();
        command
            .add_option("--start", options.start,
                        "random, or noise: a lattice that is disturbed by 2 %")
            ->capture_default_str();
        addList(command, "--kernels", options.kernels, "absent: all");
        addList(command, "--smoothing-length", options.lengths, "h/d_ref");
        addList(command, "--neighbours", options.neighbours,
                "in the kernel's support, instead of smoothing lengths");
        command.add_option("--seeds", options.seeds, "starts to take the mean of");
      },
      runPairing);
}

Command addTension(CLI::App& stability) {
  return addMap<TensionOptions>(
      stability, "tension", "at which negative pressures particles clump", R"(
Example:
  plenum-study stability tension --kernel cubic_spline --pressures=-0.1,-0.01,0,0.1)",
      [](CLI::App& command, TensionOptions& options) {
        command.add_option("--kernel", options.kernel, "smoothing kernel")->capture_default_str();
        addList(command, "--pressures", options.pressures, "p0/(rho c^2), from -1 to 1");
        addList(command, "--smoothing-length", options.lengths, "h/d_ref");
        command.add_option("--seeds", options.seeds, "of the noise, to take the mean of");
      },
      runTension);
}

Command addCollisions(CLI::App& stability) {
  return addMap<CollisionOptions>(
      stability, "collisions", "how far and how hard particles should collide", R"(
Example:
  plenum-study stability collisions --restitution 0.01 --range 0.7,0.85,1)",
      [](CLI::App& command, CollisionOptions& options) {
        command.add_option("--kernel", options.kernel, "smoothing kernel")->capture_default_str();
        addList(command, "--range", options.ranges, "delta_c [d_ref]");
        addList(command, "--restitution", options.restitutions, "C_R, from 0 to 1");
        command.add_option("--seeds", options.seeds, "starts to take the mean of");
      },
      runCollisions);
}

Command addTimeStep(CLI::App& stability) {
  return addMap<TimeStepOptions>(
      stability, "time-step", "the largest time step that scenes stand, by bisection", R"(
Example:
  plenum-study stability time-step --scenes box,tank --alpha 0.1,1)",
      [](CLI::App& command, TimeStepOptions& options) {
        addList(command, "--scenes", options.scenes, "of box, tank, shaft, dam");
        addList(command, "--alpha", options.alphas, "of Monaghan's viscosity");
      },
      runTimeStep);
}

Command addInterface(CLI::App& stability) {
  return addMap<InterfaceOptions>(
      stability, "interface", "which ratios of densities methods stand", R"(
Example:
  plenum-study stability interface --ratios 1,10,1000 --methods sums,continuity

Methods: sums are (2.2)/(2.3) of Kruisbrink et al. 2018, continuity (5.23)/(5.24); +product and
+squared have the other one's momentum equation, +collisions reach .95 d_ref.)",
      [](CLI::App& command, InterfaceOptions& options) {
        addList(command, "--ratios", options.ratios, "density of the heavy over the light fluid");
        addList(command, "--methods", options.methods, "absent: all");
      },
      runInterface);
}

}  // namespace

std::vector<Command> addMapCommands(CLI::App& stability) {
  return {addPairing(stability), addTension(stability), addTimeStep(stability),
          addCollisions(stability), addInterface(stability)};
}

}  // namespace plenum::study
