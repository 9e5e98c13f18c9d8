// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/lattice.hpp"
#include "particles/atomic_file.hpp"
#include "particles/command_line.hpp"
#include "studies/commands.hpp"
#include "studies/mode_growth.hpp"
#include "studies/mode_map.hpp"
#include "studies/pairing_map.hpp"
#include "studies/transforms.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <thread>

namespace plenum::study {

namespace {

namespace fs = std::filesystem;

int runTransforms(const StabilityOptions& options) {
  const auto transforms = transformsOf(options.kernels);
  std::cout << tableOf(transforms);
  fs::create_directories(options.folder);
  writeTextFile(options.folder / "transforms.csv", csvOf(transforms, options.smoothingLengths));
  for (int dimension = 1; dimension <= 3; ++dimension)
    writeChart(options.folder / fmt::format("transforms_{}d", dimension),
               transformChart(transforms, dimension));
  std::cout << fmt::format("written to {}\n", (options.folder / "transforms*").string());
  return exitOk;
}

int runModes(const StabilityOptions& options) {
  const ModeMap map = computeModes(options.lattice, options.backgroundPressure, options.kernels,
                                   options.smoothingLengths);
  std::cout << tableOf(map);
  fs::create_directories(options.folder);
  const fs::path file = options.folder / ("modes_" + options.lattice);
  writeTextFile(file.string() + ".csv", csvOf(map));
  writeChart(file, heatMapOf(map));
  std::cout << fmt::format("written to {}.*\n", file.string());
  return exitOk;
}

/// Boxes of eight cells in the plane, of four in space, or of more where the kernels reach further.
template <int Dim>
std::vector<MeasuredMode> measuredModes(const StabilityOptions& options, int nCells) {
  std::vector<MeasuredMode> all;
  for (const std::string& kernel : options.kernels)
    for (const double h : options.smoothingLengths) {
      const LatticeState state{options.lattice, KernelId::named(kernel), h,
                               options.backgroundPressure};
      const int cells = std::max(nCells, static_cast<int>(std::ceil(4 * h)) + 1);
      for (const MeasuredMode& mode : measureExtremes<Dim>(state, cells)) all.push_back(mode);
    }
  return all;
}

int runGrowth(const StabilityOptions& options) {
  const bool isPlane = std::ranges::count(latticeNames(2), options.lattice) > 0;
  const auto modes = isPlane ? measuredModes<2>(options, 8) : measuredModes<3>(options, 4);
  std::cout << tableOf(modes);
  fs::create_directories(options.folder);
  const fs::path file = options.folder / ("growth_" + options.lattice + ".csv");
  writeTextFile(file, csvOf(modes));
  std::cout << fmt::format("written to {}\n", file.string());
  return exitOk;
}

int runPairing(const StabilityOptions& options) {
  if (!fs::exists(options.cases / "gas_box.toml"))
    throw InputError(fmt::format("{}: no such case; name the folder of Plenum's cases with --cases",
                                 (options.cases / "gas_box.toml").string()));
  const PairingMap map = measurePairing(options);
  std::cout << tableOf(map);
  writeTextFile(options.folder / "pairing.csv", csvOf(map));
  writeChart(options.folder / "pairing", heatMapOf(map));
  std::cout << fmt::format("written to {}\n", (options.folder / "pairing.*").string());
  return exitOk;
}

/// A subcommand with the options that all have.
CLI::App* add(CLI::App& stability, StabilityOptions& options, const char* name, const char* what) {
  CLI::App* command = stability.add_subcommand(name, what);
  command->add_option("--kernels", options.kernels, "kernels, by their names in cases")
      ->delimiter(',');
  command->add_option("--smoothing-length", options.smoothingLengths, "h/d_ref")
      ->delimiter(',')
      ->check(CLI::Range(0.5, 10.0))
      ->capture_default_str();
  command->add_option("-o,--output", options.folder, "folder")->capture_default_str();
  command->add_flag("-q,--quiet", options.quiet, "no progress");
  return command;
}

}  // namespace

std::vector<Command> addStability(CLI::App& app) {
  CLI::App* stability = app.add_subcommand("stability", "where methods become unstable");
  stability->require_subcommand(1);
  stability->footer(R"(
Examples:
  plenum-study stability transforms
  plenum-study stability modes --lattice fcc --smoothing-length 1.2,1.5 --background-pressure 0.1
  plenum-study stability pairing --kernels wendland_c2,convex --smoothing-length 1.5,2 --seeds 3)");
  const auto transforms = std::make_shared<StabilityOptions>();
  transforms->folder = "stability";
  transforms->smoothingLengths = {1.2, 1.5, 2, 2.5, 3};
  CLI::App* transformsCommand =
      add(*stability, *transforms, "transforms",
          "where the kernels' Fourier transforms are negative, in 1-D, 2-D and 3-D");

  const auto modes = std::make_shared<StabilityOptions>(*transforms);
  modes->kernels = KernelId::names();
  modes->smoothingLengths = {1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 2, 2.5, 3};
  CLI::App* modesCommand =
      add(*stability, *modes, "modes", "which waves grow on a perfect lattice, by linear theory");
  const auto growth = std::make_shared<StabilityOptions>(*modes);
  growth->kernels = {"cubic_spline", "quintic_spline", "wendland_c2", "wendland_c2_1d", "convex"};
  growth->smoothingLengths = {1.3, 1.8};
  CLI::App* growthCommand = add(*stability, *growth, "growth",
                                "how the solver moves waves of a lattice, beside linear theory");
  for (const auto& [command, options] : {std::pair{modesCommand, modes}, {growthCommand, growth}}) {
    command->add_option("--lattice", options->lattice, "square, hexagonal, cubic, bcc, fcc or hcp")
        ->check(CLI::IsMember({"square", "hexagonal", "cubic", "bcc", "fcc", "hcp"}))
        ->capture_default_str();
    command->add_option("--background-pressure", options->backgroundPressure, "p0 [rho0 c^2]")
        ->capture_default_str();
  }

  const auto pairing = std::make_shared<StabilityOptions>(*transforms);
  pairing->kernels = KernelId::names();
  pairing->cases = "cases";
  pairing->jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  CLI::App* pairingCommand =
      add(*stability, *pairing, "pairing", "which kernels pair, measured in the gas box of [C]");
  pairingCommand->add_option("--seeds", pairing->seeds, "runs for each cell, of seeds 1, 2, ...")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  pairingCommand->add_option("--cases", pairing->cases, "folder of Plenum's cases")
      ->capture_default_str();
  pairingCommand->add_option("-j,--jobs", pairing->jobs, "runs at once")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  pairingCommand->add_option("--programs", pairing->programs,
                             "folder of plenum-ic and plenum-sph [beside plenum-study]");
  return {{transformsCommand, [transforms] { return runTransforms(*transforms); }},
          {modesCommand, [modes] { return runModes(*modes); }},
          {growthCommand, [growth] { return runGrowth(*growth); }},
          {pairingCommand, [pairing] { return runPairing(*pairing); }}};
}

}  // namespace plenum::study
