// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/lattice.hpp"
#include "particles/atomic_file.hpp"
#include "particles/command_line.hpp"
#include "particles/progress.hpp"
#include "studies/commands.hpp"
#include "studies/list_option.hpp"
#include "studies/mode_growth.hpp"
#include "studies/mode_map.hpp"
#include "studies/transforms.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <memory>

namespace plenum::study {

namespace {

namespace fs = std::filesystem;

struct LatticeOptions {
  fs::path folder = "stability";
  std::vector<std::string> kernels = KernelId::names();
  std::vector<double> smoothingLengths{1.1, 1.2, 1.3, 1.4, 1.5, 1.6,
                                       1.7, 1.8, 2,   2.5, 3};  // [d_ref]
  std::string lattice = "hexagonal";
  std::vector<double> backgroundPressures{1};  // p0 [rho0 c^2]
};

void requireUsable(const LatticeOptions& options) {
  requireWords("--kernels", options.kernels, KernelId::names());
  requireNumbers("--smoothing-length", options.smoothingLengths, 0.6, 6);  // the solver's own
  requireNumbers("--background-pressure", options.backgroundPressures, -1, 100);
}

bool isOfThePlane(const std::string& lattice) {
  return std::ranges::count(latticeNames(2), lattice) > 0;
}

int runTransforms(const LatticeOptions& options) {
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

int runModes(const LatticeOptions& options) {
  const ModeMap map = computeModes(options.lattice, options.backgroundPressures, options.kernels,
                                   options.smoothingLengths);
  std::cout << tableOf(map);
  fs::create_directories(options.folder);
  const bool isOfPressures = options.backgroundPressures.size() > 1;
  const fs::path file =
      options.folder / ("modes_" + options.lattice + (isOfPressures ? "_pressures" : ""));
  writeTextFile(file.string() + ".csv", csvOf(map));
  writeChart(file, heatMapOf(map));
  std::cout << fmt::format("written to {}.*\n", file.string());
  return exitOk;
}

/// Boxes of eight cells in the plane, of four in space, or of more where the kernels reach further.
template <int Dim>
std::vector<MeasuredMode> measuredModes(const LatticeOptions& options) {
  std::vector<MeasuredMode> all;
  Progress progress(
      "growth", static_cast<double>(options.kernels.size() * options.backgroundPressures.size() *
                                    options.smoothingLengths.size()));
  double nDone = 0;
  for (const std::string& kernel : options.kernels)
    for (const double pressure : options.backgroundPressures)
      for (const double h : options.smoothingLengths) {
        const LatticeState state{options.lattice, KernelId::named(kernel), h, pressure};
        const int nCells = std::max(Dim == 2 ? 8 : 4, static_cast<int>(std::ceil(4 * h)) + 1);
        std::ranges::move(measureExtremes<Dim>(state, nCells), std::back_inserter(all));
        progress.update(++nDone, fmt::format("{}, h = {:g} d_ref", kernel, h));
      }
  progress.finish();
  return all;
}

int runGrowth(const LatticeOptions& options) {
  const auto modes =
      isOfThePlane(options.lattice) ? measuredModes<2>(options) : measuredModes<3>(options);
  std::cout << tableOf(modes);
  fs::create_directories(options.folder);
  const fs::path file = options.folder / ("growth_" + options.lattice + ".csv");
  writeTextFile(file, csvOf(modes));
  std::cout << fmt::format("written to {}\n", file.string());
  return exitOk;
}

using Run = int (*)(const LatticeOptions&);

Command addCommand(CLI::App& stability, const char* name, const char* what, bool hasLattice,
                   LatticeOptions defaults, Run run) {
  CLI::App* command = stability.add_subcommand(name, what);
  const auto options = std::make_shared<LatticeOptions>(std::move(defaults));
  addList(*command, "--kernels", options->kernels, "by their names in cases");
  addList(*command, "--smoothing-length", options->smoothingLengths, "h/d_ref");
  command->add_option("-o,--output", options->folder, "folder of tables and charts")
      ->capture_default_str();
  if (hasLattice) {
    command->add_option("--lattice", options->lattice, "square, hexagonal, cubic, bcc, fcc or hcp")
        ->check(CLI::IsMember({"square", "hexagonal", "cubic", "bcc", "fcc", "hcp"}))
        ->capture_default_str();
    addList(*command, "--background-pressure", options->backgroundPressures, "p0/(rho0 c^2)");
  }
  return {command, [options, run] {
            requireUsable(*options);
            return run(*options);
          }};
}

}  // namespace

std::vector<Command> addLatticeCommands(CLI::App& stability) {
  LatticeOptions forTransforms, forGrowth;
  forTransforms.smoothingLengths = {1.2, 1.5, 2, 2.5, 3};
  forGrowth.kernels = {"cubic_spline", "quintic_spline", "wendland_c2", "wendland_c2_1d", "convex"};
  forGrowth.smoothingLengths = {1.3, 1.8};
  return {addCommand(stability, "transforms",
                     "where the kernels' Fourier transforms are negative, in 1-D, 2-D and 3-D",
                     false, forTransforms, runTransforms),
          addCommand(stability, "modes", "which waves grow on a perfect lattice, by linear theory",
                     true, {}, runModes),
          addCommand(stability, "growth",
                     "how the solver moves waves of a lattice, beside linear theory", true,
                     forGrowth, runGrowth)};
}

}  // namespace plenum::study
