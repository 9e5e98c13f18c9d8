// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "geometry/triangle_soup.hpp"

#include <string>

namespace plenum {

/// The region inside a closed triangle mesh. `source` begins every message; `tolerance` [m] is what
/// the triangles may be off from a curved surface.
/// Throws FaultyInput with all that `surfaceFaults` finds, or where the surface crosses itself.
GeometryPtr<3> makeSurfaceMesh(const TriangleSoup& soup, const std::string& source,
                               double tolerance = 0);

}  // namespace plenum
