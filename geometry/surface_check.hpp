// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/surface_shells.hpp"
#include "particles/findings.hpp"

#include <string>
#include <vector>

namespace plenum {

/// Throws InputError, with the number of the corner and a triangle that has it, for coordinates
/// that are not finite. `source` begins the message.
void checkFinite(const TriangleSoup& soup, const std::string& source);

/// Everything that keeps the welded `soup` from being a closed surface of one side, as errors with
/// place and remedy: triangles without area, edges without exactly two triangles that run opposite
/// ways along them, parts inside out (outside is where corners run counter-clockwise, in cavities
/// the other way round). Sides in and out are looked at only if nothing else is wrong.
std::vector<Finding> surfaceFaults(const TriangleSoup& soup, const std::string& source);

/// "3 holes, the largest 0.02 m across, at (0, 1, 0)"; "" for no holes.
std::string describeHoles(const std::vector<Hole>& holes);

/// A point as findings have it.
inline std::vector<double> placeOf(const Vec<3>& x) { return {x[0], x[1], x[2]}; }

}  // namespace plenum
