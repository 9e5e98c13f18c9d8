// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study varies: axes of settings, and the grid that they span.
#pragma once

#include "studies/run_store.hpp"

#include <string>
#include <vector>

namespace plenum::study {

/// The parts of `text` between separators that stand in no brackets and no quotation marks.
std::vector<std::string> splitOutsideBrackets(const std::string& text, char separator);

/// One axis. Its values stand for settings of the case, several at once where keys are tied.
struct Variation {
  std::vector<std::string> names;                ///< as given: "kernel"; several if tied
  std::vector<std::string> keys;                 ///< as the case has them: "solver.kernel"
  std::vector<std::vector<std::string>> values;  ///< [value][key]
  std::vector<std::size_t> places{0};            ///< of each name's first key

  /// "kernel=convex,wendland_c2", or tied keys "spacing:solver.time_step=0.02:4e-4,0.01:2e-4".
  /// Commas and colons inside brackets or quotation marks belong to a value. A value `case` is what
  /// the case says.
  ///
  /// Keys of [solver] may go without "solver."; `lattice` is that of all fluids of the case; `h` is
  /// solver.smoothing_length; `threads` is how plenum-sph runs, and `time_step_factor` multiplies
  /// the step, or the Courant number, that the case has. Throws InputError for a key that the case
  /// cannot have, with the nearest one.
  static Variation parse(const std::string& text, const std::filesystem::path& caseFile);

  std::string name() const;                     ///< tied names with colons between
  std::string textOf(std::size_t value) const;  ///< as given; of tied keys "random:{}"
  /// Of one of the names.
  const std::string& textOf(std::size_t value, std::size_t name) const {
    return values[value][places[name]];
  }

  bool isOfThreads() const;  ///< the number of threads is varied
};

/// A point of the grid.
struct Combination {
  std::vector<std::size_t> at;  ///< value of each axis
  RunRequest request;
};

/// All combinations, the last axis fastest, of a case with the settings and options of `base`. A
/// time step that the case fixes keeps its ratio to the spacing where that is varied and nobody
/// names the step.
std::vector<Combination> gridOf(const std::vector<Variation>& axes, const RunRequest& base);

/// "convex, h = 2, spacing 0.01": the values of a combination, for people.
std::string describe(const std::vector<Variation>& axes, const std::vector<std::size_t>& at);

}  // namespace plenum::study
