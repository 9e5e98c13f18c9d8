// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/command_line.hpp"
#include "studies/case_options.hpp"
#include "studies/commands.hpp"

#include <iostream>
#include <memory>

namespace plenum::study {

namespace {

struct AccuracyLine {
  AccuracyOptions options;
  std::vector<std::string> compared;
};

int run(AccuracyLine& line) {
  AccuracyOptions& options = line.options;
  if (line.compared.size() % 2 != 0)
    throw InputError(
        "--compare: takes two settings, --compare kernel=convex,h=2 "
        "kernel=wendland_c2,h=1.5");
  for (std::size_t k = 0; k < line.compared.size(); k += 2)
    options.comparisons.emplace_back(line.compared[k], line.compared[k + 1]);
  if (options.folder.empty()) options.folder = options.caseFile.stem().string() + "_accuracy";
  const Study study = runAccuracy(options);
  writeAccuracy(study, options);
  if (!options.quiet) std::cout << tableOf(study);
  for (const std::string& sentence : sentencesOf(study, options)) std::cout << sentence << "\n";
  std::cout << fmt::format("report: {}\n", (options.folder / "report.html").string());
  return exitOk;
}

}  // namespace

Command addAccuracy(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("accuracy", "run a case over a grid of settings: error against cost");
  command->footer(R"(
Example, the tank of water at rest:
  plenum-study accuracy cases/hydrostatic_tank.toml --vary kernel=convex,wendland_c2 \
    --vary h=1.5,2 --vary precision=mixed,double --within 1

An interrupted study goes on where it stopped: begin it again with the same folder.)");
  const auto line = std::make_shared<AccuracyLine>();
  AccuracyOptions& options = line->options;
  addCaseOptions(*command, options);
  command->add_option("--within", options.within, "errors to advise on, in the quantity's unit")
      ->check(CLI::Validator(notPositive, "ABOVE 0"));
  command
      ->add_option("--compare", line->compared,
                   "two settings to compare at equal error: kernel=convex,h=2 "
                   "kernel=wendland_c2,h=1.5")
      ->expected(2);
  command
      ->add_option("-j,--jobs", options.jobs,
                   "runs at once; with more than one on a busy machine, times mean less")
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--repeats", options.repeats,
                   "of each run; the least time counts, which a busy machine disturbs least")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  return {command, [line] { return run(*line); }};
}

}  // namespace plenum::study
