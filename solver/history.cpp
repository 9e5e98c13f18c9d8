// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/history.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace plenum {

namespace {

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line + ",");
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

/// "name [unit]" as a figure without a value.
Figure columnOf(const std::string& cell) {
  const std::size_t open = cell.find(" [");
  if (open == std::string::npos) return {cell, "", NAN};
  return {cell.substr(0, open), cell.substr(open + 2, cell.size() - open - 3), NAN};
}

std::string headerOf(const std::vector<Figure>& figures) {
  std::string line;
  for (const Figure& f : figures)
    line += (line.empty() ? "" : ",") + f.name + (f.unit.empty() ? "" : " [" + f.unit + "]");
  return line;
}

/// A whole row; nothing for one that was cut off when its program was killed.
std::optional<std::vector<Figure>> rowOf(const std::string& line, std::vector<Figure> columns) {
  const std::vector<std::string> cells = cellsOf(line);
  if (cells.size() != columns.size()) return std::nullopt;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (cells[k].empty()) continue;
    char* end = nullptr;
    columns[k].value = std::strtod(cells[k].c_str(), &end);
    if (*end != 0) return std::nullopt;
  }
  return columns;
}

}  // namespace

History::History(std::filesystem::path path) : path_(std::move(path)), out_(path_) {
  if (!out_) throw RunError(writeFailure(path_, errno));
}

History::History(std::filesystem::path path, double time) : path_(std::move(path)) {
  std::string text;
  if (std::ifstream in(path_); in && std::getline(in, header_)) {
    text = header_ + "\n";
    std::vector<Figure> columns;
    for (const std::string& cell : cellsOf(header_)) columns.push_back(columnOf(cell));
    // Times were written with twelve digits.
    const double last = time + 1e-11 * std::abs(time);
    for (std::string line; std::getline(in, line);) {
      const auto row = rowOf(line, columns);
      if (!row || !(row->front().value <= last)) break;
      text += line + "\n";
      earlier_.push_back(*row);
    }
  }
  writeTextFile(path_, text);
  out_.open(path_, std::ios::app);
  if (!out_) throw RunError(writeFailure(path_, errno));
}

void History::requireColumns(const std::filesystem::path& path,
                             const std::vector<Figure>& figures) {
  std::ifstream in(path);
  std::string header;
  if (!std::getline(in, header) || header == headerOf(figures)) return;
  throw InputError(fmt::format(
      "{}: has other columns than this run would have; resume without --set measures, or "
      "into another folder by --output",
      path.string()));
}

void History::add(const std::vector<Figure>& figures) {
  std::string line;
  if (header_.empty()) {
    header_ = headerOf(figures);
    line = header_ + "\n";
  }
  for (std::size_t k = 0; k < figures.size(); ++k) {
    if (k > 0) line += ',';
    if (!std::isnan(figures[k].value)) line += fmt::format("{:.12g}", figures[k].value);
  }
  errno = 0;
  out_ << line << '\n' << std::flush;
  if (!out_) throw RunError(writeFailure(path_, errno != 0 ? errno : EIO));
}

}  // namespace plenum
