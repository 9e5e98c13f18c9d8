// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygon files (.wkt, .txt, .xy, .dat) hold one of two forms:
//
// 1. Well-known text (OGC 06-103r4): POLYGON ((0 0, 1 0, 1 1, 0 0), (hole), ...) or
//    MULTIPOLYGON (((...)), ...). Upper or lower case. The last corner of a ring may repeat the
//    first.
// 2. Plain loops: one corner "x y" a line (a comma between them is allowed), loops parted by blank
//    lines, # begins a comment. Loops may stand in any order: one that lies inside an odd number of
//    others is a hole.
//
// Rings may run either way round.
//
// Open lines, for walls of a thickness: LINESTRING (0 0, 1 0, ...) or MULTILINESTRING ((...), ...),
// or plain lines as above, which are then not joined at their ends.
#pragma once

#include "geometry/polygon.hpp"

#include <filesystem>

namespace plenum {

/// Throws InputError that names file and line.
std::vector<PolygonLoops> readPolygonFile(const std::filesystem::path& path);

/// Open lines. Throws InputError that names file and line.
std::vector<Loop> readLineFile(const std::filesystem::path& path);

}  // namespace plenum
