// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/file_points.hpp"

#include <string>
#include <string_view>

namespace plenum {

/// The points of a text, one a line, columns parted by commas, semicolons, tabs or blanks; # begins
/// a line that is passed over. The first line may name the columns: x, y, z, or with "position_",
/// "Points:" or "Points_" before (0, 1, 2 there), in any case, in quotes or not, a unit in brackets
/// behind; other columns are passed over. Without names the first `dimension` columns are the
/// coordinates. Where a column `type` has nothing but 0 and 1, 1 is a wall. Messages begin with
/// `source`.
///
/// Throws InputError for columns that are missing, lines that are too short and what is no number.
FilePoints readCsvPoints(std::string_view text, int dimension, const std::string& source);

}  // namespace plenum
