// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/vec.hpp"

#include <array>
#include <filesystem>
#include <vector>

namespace plenum {

/// Values on a regular grid, straight between its points, NaN outside.
template <int Dim>
struct GridTable {
  std::array<std::size_t, Dim> shape{};  ///< points along each axis, at least two
  Vec<Dim> lower, step;                  ///< place of the first point, distance of points [m]
  std::vector<double> value;             ///< the first axis runs fastest

  double at(const Vec<Dim>& x) const;
};

/// A text file with a line for each grid point, in any order: coordinates, then the value. Throws
/// InputError if the lines are no full regular grid.
template <int Dim>
GridTable<Dim> readGridTable(const std::filesystem::path& path);

/// Grey values, 0 to 1, of a PNG: lower left first. Throws InputError.
GridTable<2> readImage(const std::filesystem::path& path);

/// A text file of radii [m], rising from line to line, and values.
struct RadialTable {
  std::vector<double> radius, value;
  double at(double r) const;  ///< straight between lines; NaN outside
};
RadialTable readRadialTable(const std::filesystem::path& path);

}  // namespace plenum
