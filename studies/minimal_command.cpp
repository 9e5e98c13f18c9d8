// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/atomic_file.hpp"
#include "particles/command_line.hpp"
#include "studies/case_options.hpp"
#include "studies/commands.hpp"
#include "studies/minimal.hpp"

#include <iostream>
#include <memory>

namespace plenum::study {

namespace {

struct MinimalLine {
  AccuracyOptions options;
  double error = 0;
};

int run(MinimalLine& line) {
  AccuracyOptions& options = line.options;
  if (options.folder.empty()) options.folder = options.caseFile.stem().string() + "_minimal";
  const std::filesystem::path file =
      options.folder / (options.caseFile.stem().string() + "_minimal.toml");
  std::filesystem::remove(file);  // of an earlier search
  const Minimal minimal = findMinimal(options, line.error);
  writeTextFile(options.folder / "tried.csv", csvOf(minimal.tried));
  if (!options.quiet) std::cout << tableOf(minimal.tried);
  for (const std::string& sentence : sentencesOf(minimal, line.error))
    std::cout << sentence << "\n";
  if (!minimal.root) return exitFailure;
  const std::string text = minimal.root->printedFile(
      fmt::format("{} as far as it is needed for an error of {:g} in {}: {:g}",
                  options.caseFile.filename().string(), line.error, minimal.tried.measure.name(),
                  *minimal.error));
  writeTextFile(file, text);
  if (!options.quiet) std::cout << "\n" << text << "\n";
  std::cout << fmt::format("case: {}\n", file.string());
  return exitOk;
}

}  // namespace

Command addMinimal(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "minimal", "find the cheapest setting of a case that meets an error, and print that case");
  command->footer(R"(
Examples:
  plenum-study minimal cases/hydrostatic_tank.toml --error 1
  plenum-study minimal cases/sod.toml --error 0.02 --vary kernel=cubic_spline,wendland_c2 \
    --vary spacing=0.04,0.02,0.01

Without --vary: five kernels, h = 1.3, 1.5, 2, and 4, 2 and 1 times the case's spacing, as far as
the case can have them.
Settings are tried by rising cost; an interrupted search goes on where it stopped.)");
  const auto line = std::make_shared<MinimalLine>();
  AccuracyOptions& options = line->options;
  addCaseOptions(*command, options);
  command->add_option("--error", line->error, "that must be met, in the quantity's unit")
      ->required()
      ->check(CLI::Validator(notPositive, "ABOVE 0"));
  return {command, [line] { return run(*line); }};
}

}  // namespace plenum::study
