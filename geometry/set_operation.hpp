// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/common_region.hpp"

#include <vector>

namespace plenum {

/// Points in any of the parts. Throws InputError if nothing is outside.
template <int Dim>
GeometryPtr<Dim> unionOf(std::vector<GeometryPtr<Dim>> parts);

/// Points in all of the parts. Throws InputError if there are none.
template <int Dim>
GeometryPtr<Dim> intersectionOf(std::vector<GeometryPtr<Dim>> parts);

/// Points in the first part and in none of the others. Throws InputError if there are none.
template <int Dim>
GeometryPtr<Dim> differenceOf(std::vector<GeometryPtr<Dim>> parts);

}  // namespace plenum
