// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vec.hpp"

#include <cstddef>
#include <vector>

namespace plenum {

/// Where the fluid particles of a file stand, in the order of the file.
struct FilePoints {
  std::vector<Vec<3>> positions;  ///< components that the file does not have are zero
  std::size_t nWalls = 0;         ///< particles of the file that it calls walls, left out
};

}  // namespace plenum
