// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace plenum {

/// An image as grey values, 0 (black) to 1 (white), row by row from the lower left.
struct GreyImage {
  std::size_t width = 0, height = 0;
  std::vector<double> grey;
};

/// Reads a PNG; colours by their luma. Throws InputError if it is none, or of fewer than 2 x 2
/// pixels.
GreyImage readGreyImage(const std::filesystem::path& path);

}  // namespace plenum
