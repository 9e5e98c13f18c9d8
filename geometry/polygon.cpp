// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon.hpp"

#include "particles/errors.hpp"

namespace plenum {

GeometryPtr<2> makePolygon(std::vector<PolygonLoops>, const std::string& source, double) {
  throw InputError(source + ": polygons are not read yet");
}

}  // namespace plenum
