// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"

#include <string>
#include <vector>

namespace plenum {

/// Corners of a closed line [m]; the last is joined to the first.
using Loop = std::vector<Vec<2>>;

/// One region of the plane: an outer line and holes in it. Orientations do not matter.
struct PolygonLoops {
  Loop outer;
  std::vector<Loop> holes;
};

/// Outer lines and holes from lines in any order: a line inside an odd number of others is a hole.
/// Throws InputError as `makePolygon` does.
std::vector<PolygonLoops> nestedLoops(const std::vector<Loop>& loops, const std::string& source);

/// The region of one or more polygons with holes. `source` begins every message ("gap.wkt", or
/// file, line and key of the case). `tolerance` [m] is what the lines may be off from curved ones.
/// Throws InputError that says where: fewer than three corners, corners that are not finite, lines
/// that cross or touch themselves or each other, holes outside of the outer line.
GeometryPtr<2> makePolygon(std::vector<PolygonLoops> polygons, const std::string& source,
                           double tolerance = 0);

}  // namespace plenum
