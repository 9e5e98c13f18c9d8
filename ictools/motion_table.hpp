// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/rigid_motion.hpp"

#include <string>
#include <string_view>

namespace plenum {

/// A motion from a text file, and which columns it has.
struct MotionTableFile {
  MotionTable table;
  bool hasAngle = false;
};

/// Reads a table: the first line names the columns `time` and any of `x`, `y`, `z` (as many as
/// `dimension`) and `angle`, with their units [s], [m], [degrees] or without; then a row a line,
/// parted by commas, semicolons, tabs or (names without units) blanks; # begins a comment line.
/// `source` begins every message. Throws InputError, with the line, for unknown, missing or doubled
/// columns, what is not a number, times that do not increase, and fewer than two rows.
MotionTableFile readMotionTable(std::string_view text, int dimension, const std::string& source);

}  // namespace plenum
