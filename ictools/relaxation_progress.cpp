// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/relaxation_progress.hpp"

#include "particles/atomic_file.hpp"

#include <fmt/format.h>

#include <limits>

namespace plenum {

namespace {

/// Moves that led to a state; none led to the first.
double moveTo(const RelaxationState& state) { return state.iteration == 0 ? 0 : state.move; }

}  // namespace

void RelaxationProgress::end(const RelaxationResult& result) {
  progress_->finish(fmt::format("scatter {:.3f} % at iteration {} of {}: {}",
                                100 * result.best.scatter, result.best.iteration,
                                result.history.back().iteration, result.reason));
}

void RelaxationProgress::show(const RelaxationState& state) {
  if (!progress_) progress_.emplace("relaxing", std::numeric_limits<double>::infinity(), quiet_);
  progress_->update(0, fmt::format("iteration {}: scatter {:.3f} %, moves {:.4f} d_ref",
                                   state.iteration, 100 * state.scatter, moveTo(state)));
}

void writeHistory(const std::filesystem::path& path, const RelaxationResult& result) {
  std::string text = "iteration,scatter,worst,bias,move [d_ref]\n";
  for (const RelaxationState& state : result.history)
    text += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g}\n", state.iteration, state.scatter,
                        state.worst, state.mean - 1, moveTo(state));
  writeTextFile(path, text);
}

}  // namespace plenum
