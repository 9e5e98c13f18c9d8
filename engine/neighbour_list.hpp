// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/cell_grid.hpp"
#include "engine/periodicity.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace plenum {

/// The neighbours of each particle: indices of all others within the list radius, fluids first,
/// then walls. Kept in blocks of consecutive particles, the unit of work of a thread; the order of
/// a particle's neighbours does not depend on the number of threads.
template <int Dim>
class NeighbourList {
 public:
  struct Block {
    std::size_t first = 0;  ///< particles [first, last)
    std::size_t last = 0;
    std::vector<std::uint32_t> neighbours;  ///< of all particles of the block, one after the other
  };

  /// Rebuilds the list for particles [0, nReceivers). Positions are sorted by cell: place k of
  /// `fluidCells` is particle k, place k of `wallCells` is particle nFluid + k.
  void build(std::span<const Vec<Dim>> positions, std::size_t nReceivers, std::size_t nFluid,
             const CellGrid<Dim>& fluidCells, const CellGrid<Dim>& wallCells,
             const Periodicity<Dim>& periodicity, double radius);

  std::span<const Block> blocks() const { return blocks_; }

  std::span<const std::uint32_t> fluidsOf(const Block& block, std::size_t i) const {
    return {block.neighbours.data() + begin_[i], walls_[i] - begin_[i]};
  }
  std::span<const std::uint32_t> wallsOf(const Block& block, std::size_t i) const {
    return {block.neighbours.data() + walls_[i], end_[i] - walls_[i]};
  }
  /// Fluids and walls.
  std::span<const std::uint32_t> allOf(const Block& block, std::size_t i) const {
    return {block.neighbours.data() + begin_[i], end_[i] - begin_[i]};
  }

  /// Particles [0, nReceivers()) have neighbours here.
  std::size_t nReceivers() const { return begin_.size(); }
  std::size_t bytes() const;

 private:
  void divide(std::size_t nReceivers);

  std::vector<Block> blocks_;
  std::vector<std::uint32_t> begin_, walls_, end_;  // within the block's list; length nReceivers
};

extern template class NeighbourList<1>;
extern template class NeighbourList<2>;
extern template class NeighbourList<3>;

}  // namespace plenum
