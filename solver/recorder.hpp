// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/pvd_writer.hpp"
#include "solver/activity_clock.hpp"
#include "solver/history.hpp"
#include "solver/run.hpp"
#include "solver/simulation.hpp"

#include <chrono>
#include <optional>

namespace plenum {

/// Everything that a run leaves in its folder: NAME_0000.vtu ..., NAME.pvd, history.csv,
/// first.png, last.png, NAME_end.hdf, summary.json, validation.json; checkpoints are not its
/// business.
template <int Dim>
class Recorder {
 public:
  /// Makes the folder and removes what an earlier run of this name left there; of a run that goes
  /// on, what came after the simulation's time, but for its end file. Throws InputError for output
  /// settings that name unknown fields or fields that the run does not model, and for a folder that
  /// holds a run of another name or the checkpoints of one that has not come to its end.
  Recorder(const RunOptions& options, const CaseSettings& settings,
           const Simulation<Dim>& simulation);

  /// Rows of history.csv from before the run was stopped.
  const std::vector<std::vector<Figure>>& earlierRows() const { return history_->earlierRows(); }

  void addState(const Simulation<Dim>& simulation);  ///< the next VTU file
  void addRow(std::vector<Figure> row);              ///< the next row of history.csv
  void drawFirst(const Simulation<Dim>& simulation) const;
  /// The last picture, the end file, the summary and, if the case asks for some, the verdicts.
  /// `meanNeighbours` are others in the support of a fluid particle.
  void finish(const Simulation<Dim>& simulation, const std::vector<ValidationResult>& validation,
              std::optional<double> meanNeighbours, const ActivityClock& clock) const;

  /// Writes the state as it stands when a run fails, NAME_failed.hdf, .vtu and failed.png. Returns
  /// a sentence that says where it is, or why it could not be written; throws nothing.
  std::string saveFailed(const Simulation<Dim>& simulation) const noexcept;

  const std::vector<Figure>& lastRow() const { return row_; }
  double wallClock() const;  ///< since the run began [s]
  /// Fluid particles that this session moved on in a second of stepping, and what else took time;
  /// for people.
  std::string speed(const Simulation<Dim>& simulation, const ActivityClock& clock) const;

 private:
  void removeOldFiles(bool isContinued) const;
  std::filesystem::path stateFile(std::size_t number) const;
  void draw(
      const Simulation<Dim>& simulation, const std::string& fileName,
      bool failed = false) const;  // a failed state as balls, whose numbers need not be finite
  double updatesPerSecond(const Simulation<Dim>& simulation, const ActivityClock& clock) const;
  void writeSummary(const Simulation<Dim>& simulation, std::optional<double> meanNeighbours,
                    const ActivityClock& clock) const;

  RunOptions options_;
  CaseSettings settings_;
  FieldSet fields_;
  PvdSeries series_;  // of the VTU files; each one's number is its place in it
  std::optional<History> history_;
  std::vector<Figure> row_;
  double earlierWallClock_ = 0;  // until the run was stopped [s]
  long earlierSteps_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

extern template class Recorder<1>;
extern template class Recorder<2>;
extern template class Recorder<3>;

}  // namespace plenum
