// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/map_files.hpp"

#include "particles/atomic_file.hpp"
#include "studies/csv.hpp"
#include "studies/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace plenum::study {

namespace {

std::string cellOf(const HeatMap& map, std::size_t row, std::size_t column) {
  if (!map.texts.empty()) return map.texts[row][column];
  const double value = map.values[row][column];
  return std::isnan(value) ? "-" : fmt::format("{:.3g}", value);
}

std::string csvOf(const Map& map) {
  const auto lineOf = [](const std::vector<std::string>& cells) {
    std::vector<std::string> quoted;
    for (const std::string& cell : cells) quoted.push_back(csvCell(cell));
    return fmt::format("{}\n", fmt::join(quoted, ","));
  };
  std::string text = lineOf(map.columns);
  for (const auto& row : map.rows) text += lineOf(row);
  return text;
}

/// Charts and remarks, then every run.
Page pageOf(const Map& map) {
  PagePart charts{"Maps", map.remarks, {}, {}, {}};
  for (const MapChart& chart : map.charts) charts.svgs.push_back(svgOf(chart.map, chart.name));
  for (const MapLines& lines : map.lines) charts.svgs.push_back(svgOf(lines.chart, lines.name));
  return {"Where methods fail: " + map.name,
          {std::move(charts), {"All runs", {}, {}, {map.columns, map.rows}, {}}}};
}

}  // namespace

std::string textOf(const HeatMap& map) {
  const std::string corner = fmt::format("{} \\ {}", map.rowLabel, map.columnLabel);
  std::size_t first = corner.size();
  for (const std::string& row : map.rows) first = std::max(first, row.size());
  std::vector<std::size_t> widths;
  std::string text = fmt::format("{} ({})\n{:{}}", map.title, map.valueLabel, corner, first);
  for (std::size_t c = 0; c < map.columns.size(); ++c) {
    std::size_t width = map.columns[c].size();
    for (std::size_t r = 0; r < map.rows.size(); ++r)
      width = std::max(width, cellOf(map, r, c).size());
    widths.push_back(width);
    text += fmt::format("  {:>{}}", map.columns[c], width);
  }
  text += "\n";
  for (std::size_t r = 0; r < map.rows.size(); ++r) {
    text += fmt::format("{:{}}", map.rows[r], first);
    for (std::size_t c = 0; c < map.columns.size(); ++c)
      text += fmt::format("  {:>{}}", cellOf(map, r, c), widths[c]);
    text += "\n";
  }
  return text;
}

void publish(const Map& map, const MapOptions& options) {
  writeTextFile(options.folder / (map.name + ".csv"), csvOf(map));
  writeTextFile(options.folder / (map.name + ".html"), htmlOf(pageOf(map)));
  if (!options.quiet)
    for (const MapChart& chart : map.charts) std::cout << textOf(chart.map) << "\n";
  for (const std::string& remark : map.remarks) std::cout << remark << "\n";
  for (const MapChart& chart : map.charts) writeChart(options.folder / chart.name, chart.map);
  for (const MapLines& lines : map.lines) writeChart(options.folder / lines.name, lines.chart);
  if (!options.quiet)
    std::cout << fmt::format("table and page: {}.csv, .html\n",
                             (options.folder / map.name).string());
}

}  // namespace plenum::study
