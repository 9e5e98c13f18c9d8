// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of text files with named columns, however they are parted.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plenum {

/// The text without blanks and quotes around it.
std::string_view trimmed(std::string_view text);

/// The mark that parts columns: the first of comma, semicolon and tab that the line has, blanks if
/// none.
char separatorOf(std::string_view line);

/// The cells of a line, trimmed.
std::vector<std::string_view> cellsOf(std::string_view line, char separator);

/// A column's name in lower case, without its unit: "x" of "X [m]".
std::string columnName(std::string_view cell);

/// The unit in brackets behind a column's name, "" if there is none: "m" of "X [m]".
std::string_view columnUnit(std::string_view cell);

/// True if a cell begins as numbers do.
bool looksLikeNumber(std::string_view cell);

}  // namespace plenum
