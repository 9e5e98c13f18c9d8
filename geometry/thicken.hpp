// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thin walls: open surfaces and open lines are given a thickness and become closed. Corners are
// shifted by the mitre of the faces (edges of a line) that meet there, m with m . n = 1 for each of
// their normals n: what is flat gets exactly the thickness. The rim is closed at right angles to
// the surface.
#pragma once

#include "geometry/polygon.hpp"
#include "geometry/triangle_soup.hpp"
#include "particles/findings.hpp"

#include <string>
#include <vector>

namespace plenum {

/// Where the material is, seen from the surface or line.
enum class WallSide {
  outer,   ///< where normals point: to where corners run counter-clockwise, to the right of a line
  inner,   ///< the other side
  middle,  ///< half of it on either side
};

struct Thickening {
  double thickness = 0;  ///< > 0 [m]
  WallSide side = WallSide::outer;
};

/// The closed surface of a wall along the open surface `open`, which is mended (mend_surface.hpp)
/// as far as can be. `source` begins every message; `report` is told where more than three planes
/// meet such that the thickness is off by more than 5 %.
/// Throws FaultyInput with place and remedy: a closed part, edges with more than two triangles, a
/// surface with one side only, corners too sharp for a mitre, and a thickness above the radius of
/// curvature. Whether the result crosses itself is for `makeSurfaceMesh` to find.
TriangleSoup thickened(const TriangleSoup& open, const Thickening& how, const std::string& source,
                       const FindingSink& report);

/// The outlines of walls along open lines, each from its first corner to its last.
/// Throws InputError with place and remedy for a closed line, a line of one point, corners too
/// sharp for a mitre, and a thickness above the radius of curvature. Whether the results cross
/// themselves or each other is for `makePolygon` to find.
std::vector<PolygonLoops> thickened(const std::vector<Loop>& lines, const Thickening& how,
                                    const std::string& source);

/// What to do about a thickened surface or line that crosses itself.
std::string remedyForThickness(const Thickening& how);

}  // namespace plenum
