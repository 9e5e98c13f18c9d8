// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/rows.hpp"
#include "geometry/triangle_soup.hpp"

#include <memory>

namespace plenum {

/// Rows through a closed surface that `checkClosedSurface` passes and that does not cross itself.
/// `soup` must outlive the answer; `step` and `near` as in Geometry::rowClassifier.
std::unique_ptr<const RowClassifier<3>> classifierOfTriangles(const TriangleSoup& soup,
                                                              const Vec<3>& step, double near);

}  // namespace plenum
