// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vec.hpp"

namespace plenum {

/// +1 if q lies on the left of the way from a to b, -1 on the right, 0 on the line through them:
/// exact for the coordinates as they are, so orientation(b, a, q) = -orientation(a, b, q).
/// Coordinates whose products overflow or underflow are not expected.
int orientation(const Vec<2>& a, const Vec<2>& b, const Vec<2>& q);

}  // namespace plenum
