// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of one case over a grid of two axes, with some seeds in each cell.
#pragma once

#include "studies/maps/map_files.hpp"
#include "studies/run_store.hpp"

#include <functional>
#include <string>
#include <vector>

namespace plenum::study {

/// A place on an axis: how it is printed, and the settings "key=value" that it stands for.
struct GridValue {
  std::string text;
  std::vector<std::string> settings;
};

struct GridAxis {
  std::string name;
  std::vector<GridValue> values;
};

/// An axis of numbers, `key`=VALUE each.
GridAxis numberAxis(const std::string& name, const std::string& key,
                    const std::vector<double>& values);
/// An axis of words, `key`=WORD each.
GridAxis wordAxis(const std::string& name, const std::string& key,
                  const std::vector<std::string>& values);

struct GridPlan {
  std::filesystem::path caseFile;
  std::vector<std::string> settings;  ///< of all runs
  GridAxis rows, columns;
  int seeds = 1;           ///< of fluid[0].seed, from 1 on
  bool variesSeed = true;  ///< false where nothing is random
  std::string label;       ///< of the progress
};

/// A number that a run leaves; NaN where there is none.
using Figure = std::function<double(const RunOutcome&)>;
/// A figure of the last state by its name in summary.json; NaN for runs that failed.
Figure lastFigure(const std::string& name);

struct Grid {
  GridPlan plan;
  std::vector<std::vector<std::vector<RunOutcome>>> outcomes;  ///< [row][column][seed]

  /// A figure of a cell, the mean of those seeds that have it; NaN if none has.
  double at(std::size_t row, std::size_t column, const Figure& figure) const;
  bool hasFailures(std::size_t row, std::size_t column) const;  ///< of any seed

  /// The figure as a chart; cells in which a seed failed have a "!" behind the number, or the time
  /// at which the first one did.
  HeatMap chart(const std::string& title, const std::string& valueLabel,
                const Figure& figure) const;

  /// A column of history.csv over time, for the first seed of each row in the grid's last column.
  Chart overTime(const std::string& title, const std::string& column,
                 const std::string& unit) const;

  /// The table of a map: a row for each run with these figures and how it failed.
  void tabulate(const std::vector<std::pair<std::string, Figure>>& figures, Map& map) const;
};

/// Runs all cells. Throws InputError for settings that cannot be used, before anything runs.
Grid runGrid(const GridPlan& plan, const MapOptions& options);

}  // namespace plenum::study
