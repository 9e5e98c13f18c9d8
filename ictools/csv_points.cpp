// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/csv_points.hpp"

#include "geometry/text_reader.hpp"
#include "ictools/csv_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace plenum {

namespace {

constexpr std::size_t noColumn = static_cast<std::size_t>(-1);

struct Columns {
  std::array<std::size_t, 3> axis{noColumn, noColumn, noColumn};
  std::size_t type = noColumn;
  std::size_t needed = 0;  ///< cells that a line must have
};

Columns namedColumns(const std::vector<std::string_view>& cells, int dimension,
                     const TextReader& reader) {
  Columns columns;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::string name = columnName(cells[k]);
    for (std::size_t a = 0; a < 3; ++a)
      for (const char* before : {"", "position_", "points:", "points_"}) {
        const char mark =
            *before == 'p' && before[1] == 'o' && before[2] == 'i' ? "012"[a] : "xyz"[a];
        if (name == fmt::format("{}{}", before, mark)) columns.axis[a] = k;
      }
    if (name == "type") columns.type = k;
  }
  for (std::size_t a = 0; a < 3; ++a)
    if (columns.axis[a] == noColumn && static_cast<int>(a) < dimension)
      reader.fail(
          fmt::format("no column is named {0}, position_{0} or Points:{1}; name the columns in the "
                      "first line, or give {2} columns of numbers alone",
                      "xyz"[a], a, dimension));
  return columns;
}

Columns columnsOf(const std::vector<std::string_view>& first, int dimension, bool hasNames,
                  const TextReader& reader) {
  Columns columns;
  if (hasNames)
    columns = namedColumns(first, dimension, reader);
  else
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) columns.axis[a] = a;
  for (const std::size_t k : columns.axis)
    if (k != noColumn) columns.needed = std::max(columns.needed, k + 1);
  if (columns.type != noColumn) columns.needed = std::max(columns.needed, columns.type + 1);
  return columns;
}

/// Leaves the walls out if `type` tells them apart.
void removeWalls(const std::vector<double>& type, FilePoints& result) {
  if (type.empty() || std::ranges::any_of(type, [](double t) { return t != 0 && t != 1; })) return;
  std::size_t k = 0;
  result.nWalls = std::erase_if(result.positions, [&](const Vec<3>&) { return type[k++] == 1; });
}

}  // namespace

FilePoints readCsvPoints(std::string_view text, int dimension, const std::string& source) {
  TextReader reader(text, source);
  FilePoints result;
  std::vector<double> type;
  std::optional<Columns> columns;
  char separator = ',';
  while (!reader.atEnd()) {
    const TextReader atLine = reader;  // messages name the line that is read
    const std::string_view line = reader.restOfLine();
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    if (!columns) separator = separatorOf(line);
    const std::vector<std::string_view> cells = cellsOf(line, separator);
    if (!columns) {
      const bool hasNames = !looksLikeNumber(cells.front());
      columns = columnsOf(cells, dimension, hasNames, atLine);
      if (hasNames) continue;
    }
    if (cells.size() < columns->needed)
      atLine.fail(fmt::format("has {} columns, needs {}; give each particle all of them",
                              cells.size(), columns->needed));
    Vec<3> x;
    for (int a = 0; a < 3; ++a)
      if (const std::size_t k = columns->axis[static_cast<std::size_t>(a)]; k != noColumn)
        x[a] = atLine.toNumber(cells[k]);
    result.positions.push_back(x);
    if (columns->type != noColumn) type.push_back(atLine.toNumber(cells[columns->type]));
  }
  removeWalls(type, result);
  return result;
}

}  // namespace plenum
