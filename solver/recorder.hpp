// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/pvd_writer.hpp"
#include "solver/history.hpp"
#include "solver/run.hpp"
#include "solver/simulation.hpp"

#include <chrono>
#include <optional>

namespace plenum {

/// Everything that a run leaves in its folder: NAME_0000.vtu ..., NAME.pvd, history.csv,
/// first.png, last.png, NAME_end.hdf, summary.json, validation.json.
template <int Dim>
class Recorder {
 public:
  /// Makes the folder and removes what an earlier run of this name left there. Throws InputError
  /// for output settings that name unknown fields or fields that the run does not model, and for a
  /// folder that holds a run of another name.
  Recorder(const RunOptions& options, const CaseSettings& settings,
           const Simulation<Dim>& simulation);

  void addState(const Simulation<Dim>& simulation);  ///< the next VTU file
  void addRow(std::vector<Figure> row);              ///< the next row of history.csv
  void drawFirst(const Simulation<Dim>& simulation) const;
  /// The last picture, the end file, the summary and, if the case asks for some, the verdicts.
  void finish(const Simulation<Dim>& simulation,
              const std::vector<ValidationResult>& validation) const;

  /// Writes the state as it stands when a run fails, NAME_failed.hdf and .vtu. Returns a sentence
  /// that says where it is, or why it could not be written; throws nothing.
  std::string saveFailed(const Simulation<Dim>& simulation) const noexcept;

  const std::vector<Figure>& lastRow() const { return row_; }
  double wallClock() const;  ///< since the run began [s]

 private:
  void removeOldFiles() const;
  void draw(const Simulation<Dim>& simulation, const std::string& fileName) const;
  void writeSummary(const Simulation<Dim>& simulation) const;

  RunOptions options_;
  CaseSettings settings_;
  std::optional<FieldSet> fields_;
  PvdSeries series_;
  std::optional<History> history_;
  std::vector<Figure> row_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

extern template class Recorder<1>;
extern template class Recorder<2>;
extern template class Recorder<3>;

}  // namespace plenum
