// SPDX-License-Identifier: GPL-3.0-or-later
//
// Charts of studies, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

struct ChartPoint {
  double x = 0, y = 0;
  std::string label;  ///< shown where a browser's pointer rests on it
};

enum class SeriesStyle { points, line, dashed, linesAndPoints };

struct Series {
  std::string name;  ///< in the key; empty: not there
  SeriesStyle style = SeriesStyle::points;
  std::vector<ChartPoint> points;
  bool isNumbered = false;  ///< points have their numbers beside them, from 1
};

struct Axis {
  std::string label;
  bool isLogarithmic = false;
  std::optional<double> lowest, highest;
  std::optional<double> zero = {};  ///< of a logarithmic axis: this value is labelled 0
};

struct Chart {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
};

/// A table in colours, rows from top to bottom.
struct HeatMap {
  std::string title;
  std::string rowLabel, columnLabel, valueLabel;
  std::vector<std::string> rows, columns;
  std::vector<std::vector<double>> values;      ///< [row][column]; not a number: nothing there
  std::vector<std::vector<std::string>> texts;  ///< printed in the cells; empty: the values
  std::optional<double> lowest, highest;        ///< of the colours
};

/// As SVG for a page: with the points' labels as tool tips, without scripts, its ids begin with
/// `prefix`. Throws RunError if gnuplot is not there or refuses.
std::string svgOf(const Chart& chart, const std::string& prefix);
std::string svgOf(const HeatMap& map, const std::string& prefix);

/// NAME.svg and NAME.png, `path` without an ending.
void writeChart(const std::filesystem::path& path, const Chart& chart);
void writeChart(const std::filesystem::path& path, const HeatMap& map);

}  // namespace plenum::study
