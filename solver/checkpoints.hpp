// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/simulation.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace plenum {

/// The checkpoints of a run in its folder: particle files NAME_checkpoint_STEP.hdf, of which the
/// last few are kept.
class Checkpoints {
 public:
  Checkpoints(std::filesystem::path folder, std::string name, int nKept)
      : folder_(std::move(folder)), name_(std::move(name)), nKept_(nKept) {}

  /// Writes the state of a simulation that may pause, then removes the oldest ones. The file
  /// appears under its name only when it is complete. Returns its path. Throws RunError.
  template <int Dim>
  std::filesystem::path write(Simulation<Dim>& simulation) const;

  /// All there are, the oldest first.
  std::vector<std::filesystem::path> all() const;

  /// The name of the run that left a file, from the file's name: of a checkpoint, an end file or a
  /// failed state what stands before that, else the stem.
  static std::string runNameOf(const std::filesystem::path& file);

  /// The newest checkpoint in a folder. Throws InputError if it has none, or those of several runs.
  static std::filesystem::path newestIn(const std::filesystem::path& folder);

 private:
  std::filesystem::path folder_;
  std::string name_;
  int nKept_;
};

}  // namespace plenum
