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
  SpatialOrder();
  ~SpatialOrder();
  SpatialOrder(SpatialOrder&&) noexcept;
  SpatialOrder& operator=(SpatialOrder&&) noexcept;

  /// order[k] becomes the index of the point in place k. The result depends on the points and their
  /// present order only. `order` and the two work spaces are as long as `points`.
  void sort(std::span<const Vec<Dim>> points, std::span<std::uint32_t> order,
            std::span<std::uint32_t> sorted, std::span<std::uint32_t> cell);

  /// Ends of the cells, in places of the order: where it is better to begin a new eight.
  std::span<const std::size_t> cellEnds() const { return cellEnds_; }

 private:
  struct Packer;

  void divide(std::size_t first, std::size_t last, int depth);

  // Of the present call.
  std::span<const Vec<Dim>> points_;
  std::span<std::uint32_t> order_, sorted_, cell_;
  std::vector<std::size_t> cellEnds_;  // of the ranges that a Packer works on
  std::vector<std::uint32_t> starts_;  // of the cells of the grids that are being divided
  std::vector<Packer> packers_;        // one a thread
};

extern template class SpatialOrder<1>;
extern template class SpatialOrder<2>;
extern template class SpatialOrder<3>;

}  // namespace plenum
