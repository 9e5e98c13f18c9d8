// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/triangle_soup.hpp"

#include <functional>

namespace plenum {

/// How far the surface is from the origin along a unit vector [m]; positive.
using RadiusAlong = std::function<double(const Vec<3>&)>;

/// A closed surface around the origin of 20 `frequency`^2 triangles: an icosahedron whose edges are
/// parted in `frequency`, its points moved out to `radius`.
TriangleSoup starShapedMesh(int frequency, const RadiusAlong& radius);

/// A part of radius 1 m, give or take .25, with humps and hollows of every size down to two
/// triangles of a mesh of `frequency` 100.
double roughRadius(const Vec<3>& direction);

}  // namespace plenum
