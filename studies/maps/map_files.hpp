// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a map leaves: NAME.csv with a row for every run, a chart for every figure, all of it in
// NAME.html, a text on stdout.
#pragma once

#include "studies/chart.hpp"
#include "studies/maps/map_options.hpp"

#include <string>
#include <vector>

namespace plenum::study {

struct MapChart {
  std::string name;  ///< of its files, without an ending
  HeatMap map;
};

struct MapLines {
  std::string name;  ///< of its files, without an ending
  Chart chart;
};

struct Map {
  std::string name;                            ///< of its table
  std::vector<std::string> columns;            ///< of the table
  std::vector<std::vector<std::string>> rows;  ///< of the table: one for each run
  std::vector<MapChart> charts;
  std::vector<MapLines> lines;       ///< what single runs did over time
  std::vector<std::string> remarks;  ///< what the map says, in sentences
};

/// A heat map as text: its title, then rows with the cells' texts (or values).
std::string textOf(const HeatMap& map);

/// Writes the files into the folder and prints the charts as text (unless quiet) and the remarks.
/// Throws RunError if a file cannot be written.
void publish(const Map& map, const MapOptions& options);

}  // namespace plenum::study
