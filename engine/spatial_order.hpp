// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace plenum {

/// Number of particles that are loaded, tested and summed together.
inline constexpr std::size_t clusterSize = 8;

/// Orders points so that each eight in a row fill a small box, and the boxes of neighbouring
/// eights are near each other in memory, too.
///
/// Cells of some thousand points come first, one beside the other. Within a cell, the points are
/// cut into slabs of equal number along x, these into columns along y (3-D) and the last axis is
/// sorted (the packing of R-trees, Leutenegger et al. 1997, doi 10.1109/ICDE.1997.582015): the
/// boxes fit themselves to any density. Cells that hold too many points are divided again.
template <int Dim>
class SpatialOrder {
 public:
  /// order()[k] is afterwards the index of the point in place k. The result depends on the points
  /// and their present order only.
  void sort(std::span<const Vec<Dim>> points);

  std::span<const std::uint32_t> order() const { return order_; }
  std::size_t bytes() const;

 private:
  struct Scratch;

  void divide(std::span<const Vec<Dim>> points, std::size_t first, std::size_t last, int depth);
  void pack(std::span<const Vec<Dim>> points, std::size_t first, std::size_t last,
            Scratch& scratch);

  std::vector<std::uint32_t> order_, sorted_, cell_;
  std::vector<std::size_t> cellEnd_;  // ends of the ranges that `pack` works on
};

extern template class SpatialOrder<1>;
extern template class SpatialOrder<2>;
extern template class SpatialOrder<3>;

}  // namespace plenum
