// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/relaxation.hpp"
#include "particles/progress.hpp"

#include <filesystem>
#include <optional>

namespace plenum {

/// Shows how a relaxation goes on.
class RelaxationProgress {
 public:
  explicit RelaxationProgress(bool quiet) : quiet_(quiet) {}

  RelaxationWatch watch() {
    return [this](const RelaxationState& state) { show(state); };
  }

  /// To be called when it is over.
  void end(const RelaxationResult& result);

 private:
  void show(const RelaxationState& state);

  bool quiet_;
  std::optional<Progress> progress_;
};

/// Writes iteration, scatter, largest deviation and moves of every iteration as CSV.
void writeHistory(const std::filesystem::path& path, const RelaxationResult& result);

}  // namespace plenum
