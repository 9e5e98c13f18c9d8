// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/motion_table.hpp"

#include "geometry/text_reader.hpp"
#include "ictools/csv_cells.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <vector>

namespace plenum {

namespace {

constexpr std::size_t timeColumn = MotionTable::nColumns;

/// Where each cell of a line goes: a column of MotionTable, or timeColumn.
using Columns = std::vector<std::size_t>;

constexpr std::array<std::string_view, timeColumn + 1> columnNames{"x", "y", "z", "angle", "time"};

bool isUnit(std::string_view unit, std::size_t column) {
  if (unit.empty()) return true;
  if (column == timeColumn) return unit == "s";
  if (column < 3) return unit == "m";
  return unit == "degrees" || unit == "degree" || unit == "deg";
}

std::size_t columnOf(std::string_view cell, int dimension, const TextReader& reader) {
  std::vector<std::string> known{"time"};
  for (int a = 0; a < dimension; ++a) known.emplace_back(1, "xyz"[a]);
  if (dimension > 1) known.emplace_back("angle");
  const std::string name = columnName(cell);
  if (std::ranges::find(known, name) == known.end())
    reader.fail(fmt::format(
        "unknown column \"{}\"; the first line names the columns, in {} dimension{} of: {}",
        std::string(cell.substr(0, 20)), dimension, dimension == 1 ? "" : "s",
        fmt::join(known, ", ")));
  const auto column =
      static_cast<std::size_t>(std::ranges::find(columnNames, name) - columnNames.begin());
  if (!isUnit(columnUnit(cell), column))
    reader.fail(fmt::format("column \"{}\" is in {}, must be in {}; convert it", name,
                            columnUnit(cell),
                            column == timeColumn ? "s" : (column < 3 ? "m" : "degrees")));
  return column;
}

Columns columnsOf(const std::vector<std::string_view>& cells, int dimension,
                  const TextReader& reader) {
  Columns columns;
  for (const std::string_view cell : cells) {
    const std::size_t column = columnOf(cell, dimension, reader);
    if (std::ranges::find(columns, column) != columns.end())
      reader.fail(fmt::format("has two columns \"{}\"; leave one out", columnNames[column]));
    columns.push_back(column);
  }
  if (std::ranges::find(columns, timeColumn) == columns.end())
    reader.fail("no column is named time; name the columns in the first line");
  if (columns.size() < 2)
    reader.fail("has the column time only; add x, y, z [m] or angle [degrees]");
  return columns;
}

void addRow(const std::vector<std::string_view>& cells, const Columns& columns, MotionTable& table,
            const TextReader& reader) {
  if (cells.size() != columns.size())
    reader.fail(fmt::format("has {} columns, needs {}; give each row all of them", cells.size(),
                            columns.size()));
  double time = 0;
  auto& place = table.places.emplace_back();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const double number = reader.toNumber(cells[k]);
    if (columns[k] == timeColumn)
      time = number;
    else
      place[columns[k]] = columns[k] < 3 ? number : number * std::numbers::pi / 180;
  }
  if (!table.empty() && !(time > table.times.back()))
    reader.fail(
        fmt::format("time = {:g} s is not after {:g} s of the row before; sort the rows "
                    "and leave double ones out",
                    time, table.times.back()));
  table.times.push_back(time);
}

}  // namespace

MotionTableFile readMotionTable(std::string_view text, int dimension, const std::string& source) {
  TextReader reader(text, source);
  MotionTableFile file;
  std::optional<Columns> columns;
  char separator = ',';
  while (!reader.atEnd()) {
    const TextReader atLine = reader;  // messages name the line that is read
    const std::string_view line = reader.restOfLine();
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    if (!columns) {
      separator = separatorOf(line);
      columns = columnsOf(cellsOf(line, separator), dimension, atLine);
    } else {
      addRow(cellsOf(line, separator), *columns, file.table, atLine);
    }
  }
  if (file.table.times.size() < 2)
    reader.fail(fmt::format("has {} row{} of numbers, needs two or more", file.table.times.size(),
                            file.table.times.size() == 1 ? "" : "s"));
  file.hasAngle = std::ranges::find(*columns, MotionTable::nColumns - 1) != columns->end();
  return file;
}

}  // namespace plenum
