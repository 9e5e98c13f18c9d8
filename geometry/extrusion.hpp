// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"

namespace plenum {

/// The points whose (x, y) lie in `base` and whose z lies between `lower` and `upper` [m],
/// lower < upper. Everything is as exact as `base` is.
GeometryPtr<3> extruded(GeometryPtr<2> base, double lower, double upper);

}  // namespace plenum
