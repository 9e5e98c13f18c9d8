// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/case_options.hpp"

#include "particles/command_line.hpp"
#include "studies/numbers.hpp"

namespace plenum::study {

void addCaseOptions(CLI::App& command, AccuracyOptions& options) {
  command.add_option("CASE", options.caseFile, "case file (TOML)")->required();
  command
      .add_option("--vary", options.vary,
                  "KEY=VALUE,VALUE: an axis of the grid; keys of [solver] without \"solver.\", "
                  "h, spacing, lattice, walls, threads, time_step_factor, or any key in full; "
                  "KEY:KEY=VALUE:VALUE,VALUE:VALUE ties keys; the value case: as the case has it")
      ->allow_extra_args(false);
  command.add_option("--set", options.settings, "a value of the case in all runs: key=value")
      ->allow_extra_args(false);
  command.add_flag("--quick", options.quick, "with the values of the case's table [quick]");
  command.add_option("--quantity", options.quantity,
                     "QUANTITY[:STATISTIC] of [[validate]] that is the error; absent: the first");
  command.add_flag("--against-case", options.isAgainstCase,
                   "errors are relative differences from a run of the case itself, for "
                   "quantities of [[validate]] that expect no value");
  command.add_option("-o,--output", options.folder,
                     "folder [CASE's name + _ + the command's, here]");
  command.add_option("--programs", options.programs,
                     "folder of plenum-ic and plenum-sph [beside plenum-study]");
  command.add_flag("-q,--quiet", options.quiet, "print what was found only");
}

std::string notPositive(const std::string& text) {
  const std::optional<double> number = numberIn(text);
  return number && *number > 0 ? "" : text + " is no number above 0";
}

}  // namespace plenum::study
