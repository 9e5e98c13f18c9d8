// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/neighbour_list.hpp"

#include <omp.h>

#include <algorithm>

namespace plenum {

namespace {
/// Small enough to balance the load of a few threads, large enough for one vector a block.
constexpr std::size_t minBlock = 256;
constexpr std::size_t blocksPerThread = 16;
}  // namespace

template <int Dim>
void NeighbourList<Dim>::divide(std::size_t nReceivers) {
  const std::size_t wanted = blocksPerThread * static_cast<std::size_t>(omp_get_max_threads());
  const std::size_t size = std::max(minBlock, (nReceivers + wanted - 1) / wanted);
  const std::size_t n = (nReceivers + size - 1) / size;
  if (blocks_.size() != n) blocks_.resize(n);
  for (std::size_t b = 0; b < n; ++b) {
    blocks_[b].first = b * size;
    blocks_[b].last = std::min(nReceivers, (b + 1) * size);
  }
  begin_.resize(nReceivers);
  walls_.resize(nReceivers);
  end_.resize(nReceivers);
}

template <int Dim>
void NeighbourList<Dim>::build(std::span<const Vec<Dim>> positions, std::size_t nReceivers,
                               std::size_t nFluid, const CellGrid<Dim>& fluidCells,
                               const CellGrid<Dim>& wallCells, const Periodicity<Dim>& periodicity,
                               double radius) {
  divide(nReceivers);
  const double radiusSquared = radius * radius;
  const bool hasWalls = nFluid < positions.size();

#pragma omp parallel for schedule(dynamic, 1)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks_.size()); ++b) {
    Block& block = blocks_[static_cast<std::size_t>(b)];
    std::vector<std::uint32_t>& list = block.neighbours;
    list.clear();
    for (std::size_t i = block.first; i < block.last; ++i) {
      const Vec<Dim> x = positions[i];
      const auto append = [&](std::size_t first, std::size_t last) {
        // Branch-free filter: write always, advance only if the pair is near.
        const std::size_t old = list.size();
        list.resize(old + (last - first));
        std::uint32_t* next = list.data() + old;
        for (std::size_t j = first; j < last; ++j) {
          const Vec<Dim> d = periodicity.nearestImage(x - positions[j]);
          *next = static_cast<std::uint32_t>(j);
          next += (normSquared(d) < radiusSquared) & (j != i);
        }
        list.resize(static_cast<std::size_t>(next - list.data()));
      };
      begin_[i] = static_cast<std::uint32_t>(list.size());
      fluidCells.forEachRange(x, append);
      walls_[i] = static_cast<std::uint32_t>(list.size());
      if (hasWalls)
        wallCells.forEachRange(
            x, [&](std::size_t first, std::size_t last) { append(nFluid + first, nFluid + last); });
      end_[i] = static_cast<std::uint32_t>(list.size());
    }
    // Room for the lists to grow a little without another allocation.
    if (list.capacity() < list.size() + list.size() / 4)
      list.reserve(list.size() + list.size() / 2);
  }
}

template <int Dim>
std::size_t NeighbourList<Dim>::bytes() const {
  std::size_t sum = (begin_.capacity() + walls_.capacity() + end_.capacity()) * 4;
  for (const Block& block : blocks_) sum += block.neighbours.capacity() * 4;
  return sum;
}

template class NeighbourList<1>;
template class NeighbourList<2>;
template class NeighbourList<3>;

}  // namespace plenum
