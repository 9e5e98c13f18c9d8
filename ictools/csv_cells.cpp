// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/csv_cells.hpp"

#include <algorithm>
#include <cctype>

namespace plenum {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view edges = " \t\r\"'";
  const std::size_t first = text.find_first_not_of(edges);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(edges) - first + 1);
}

char separatorOf(std::string_view line) {
  for (const char mark : {',', ';', '\t'})
    if (line.find(mark) != std::string_view::npos) return mark;
  return ' ';
}

std::vector<std::string_view> cellsOf(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  if (separator == ' ') line = trimmed(line);
  while (true) {
    const std::size_t end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
    if (separator == ' ') line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  }
}

std::string columnName(std::string_view cell) {
  std::string name(trimmed(cell.substr(0, cell.find('['))));
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

std::string_view columnUnit(std::string_view cell) {
  const std::size_t open = cell.find('[');
  if (open == std::string_view::npos) return {};
  cell.remove_prefix(open + 1);
  return trimmed(cell.substr(0, cell.find(']')));
}

bool looksLikeNumber(std::string_view cell) {
  return !cell.empty() && (std::isdigit(static_cast<unsigned char>(cell.front())) != 0 ||
                           cell.front() == '-' || cell.front() == '+' || cell.front() == '.');
}

}  // namespace plenum
