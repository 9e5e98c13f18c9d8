// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace plenum {

/// Pieces of a region and the volumes [m^d] that they stand for.
template <int Dim>
struct Cells {
  std::vector<Vec<Dim>> centers;  ///< in the region [m]
  std::vector<double> volumes;    ///< [m^d]
  bool isSampled = false;         ///< some were left out, others stand for them
  bool isComplete = true;         ///< false: there would have been more than `limit`
};

/// How a region is cut into cells.
template <int Dim>
struct CellSizes {
  double coarsest = 0;  ///< no edge is longer than that [m]
  /// Writes how long the edge of a cell at each center may be [m]; from several threads.
  std::function<void(std::span<const Vec<Dim>>, std::span<double>)> at;
  /// Where there would be more cells of one size, some are left out at random and others stand for
  /// them: sums keep their mean.
  std::size_t most = std::numeric_limits<std::size_t>::max();
  /// Nothing more is cut once there are as many.
  std::size_t limit = std::numeric_limits<std::size_t>::max();
};

/// Cuts `box` into about cubic cells and these into halves along each axis until they are as small
/// as `sizes` wants; returns those whose center lies in `region` (null: all), deeper than
/// `roundOff` [m]. Those that follow each other along Hilbert's curve stand beside each other.
template <int Dim>
Cells<Dim> cellsOf(const Geometry<Dim>* region, const Box<Dim>& box, const CellSizes<Dim>& sizes,
                   double roundOff);

}  // namespace plenum
