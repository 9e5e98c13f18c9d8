// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/spatial_order.hpp"

#include "particles/parallel.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

namespace plenum {

namespace {

/// Points of a full cell: 16 x 16 clusters in 2-D, 8 x 8 x 8 in 3-D.
template <int Dim>
constexpr std::size_t cellPoints = Dim == 3 ? 4096 : 2048;

constexpr int maxDepth = 24;  // then the points coincide, but for rounding

/// A regular grid over a box, its cells counted in serpentines: consecutive cells share a side.
template <int Dim>
struct Serpentine {
  Vec<Dim> lower, cellsPerLength;
  std::array<std::uint32_t, Dim> shape;

  Serpentine(const Box<Dim>& box, double nCells) : lower(box.lower) {
    // Cells as near to cubes as the box allows; flat axes get one cell.
    std::array<double, Dim> extent;
    for (int a = 0; a < Dim; ++a) extent[static_cast<std::size_t>(a)] = box.upper[a] - box.lower[a];
    double edge = 0;
    std::array<double, Dim> sorted = extent;
    std::ranges::sort(sorted);
    double left = nCells;
    for (int a = 0; a < Dim; ++a) {
      double product = 1;
      for (int b = a; b < Dim; ++b) product *= sorted[static_cast<std::size_t>(b)];
      edge = std::pow(product / left, 1.0 / (Dim - a));
      if (sorted[static_cast<std::size_t>(a)] >= edge) break;
    }
    for (int a = 0; a < Dim; ++a) {
      const double length = extent[static_cast<std::size_t>(a)];
      const double n = edge > 0 ? std::clamp(std::round(length / edge), 1.0, 4 * nCells) : 1;
      shape[static_cast<std::size_t>(a)] = static_cast<std::uint32_t>(n);
      cellsPerLength[a] = length > 0 ? n / length : 0;
    }
  }

  std::size_t nCells() const {
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>{});
  }

  std::uint32_t cellOf(const Vec<Dim>& x) const {
    std::uint32_t index = 0;
    for (int a = Dim - 1; a >= 0; --a) {
      const std::uint32_t n = shape[static_cast<std::size_t>(a)];
      auto k = static_cast<std::uint32_t>((x[a] - lower[a]) * cellsPerLength[a]);
      k = std::min(k, n - 1);
      // Every other row runs backwards.
      index = index * n + ((index & 1) != 0 ? n - 1 - k : k);
    }
    return index;
  }
};

template <int Dim>
Box<Dim> boundsOf(std::span<const Vec<Dim>> points, std::span<const std::uint32_t> indices) {
  Box<Dim> box = Box<Dim>::nothing();
  for (int a = 0; a < Dim; ++a) {
    double lower = box.lower[a], upper = box.upper[a];
    const std::size_t n = indices.size();
#pragma omp parallel for schedule(static) reduction(min      \
                                                    : lower) \
    reduction(max                                            \
              : upper) if (n >= worthThreads)
    for (std::size_t k = 0; k < n; ++k) {
      lower = std::min(lower, points[indices[k]][a]);
      upper = std::max(upper, points[indices[k]][a]);
    }
    box.lower[a] = lower;
    box.upper[a] = upper;
  }
  return box;
}

/// The part of the box of a cell that all points lie in but for a few strays: bins as wide as the
/// way to a stray would not tell the others apart.
template <int Dim>
Box<Dim> bulkOf(std::span<const Vec<Dim>> points, std::span<const std::uint32_t> indices,
                Box<Dim> box) {
  constexpr std::size_t nSamples = 128, nStrays = 2;  // at each end
  if (indices.size() < nSamples) return box;
  for (int a = 0; a < Dim; ++a) {
    std::minstd_rand generator;  // no regular choice, which rows of a lattice could deceive
    std::array<double, nSamples> x;
    for (double& value : x) value = points[indices[generator() % indices.size()]][a];
    std::ranges::sort(x);
    const double lower = x[nStrays], upper = x[nSamples - 1 - nStrays];
    if (lower == upper) continue;
    box.lower[a] = std::max(box.lower[a], lower - (upper - lower));
    box.upper[a] = std::min(box.upper[a], upper + (upper - lower));
  }
  return box;
}

}  // namespace

/// Orders the points of a cell by slabs, columns and the last axis.
template <int Dim>
struct SpatialOrder<Dim>::Packer {
  std::vector<std::uint32_t> keys, count, other;

  void pack(std::span<const Vec<Dim>> points, std::span<std::uint32_t> indices);

 private:
  void sortByKey(std::span<std::uint32_t> indices, std::size_t nKeys);
};

/// Sorts `indices` by keys[k] in [0, nKeys), stable.
template <int Dim>
void SpatialOrder<Dim>::Packer::sortByKey(std::span<std::uint32_t> indices, std::size_t nKeys) {
  count.assign(nKeys + 1, 0);
  const std::size_t n = indices.size();
  for (std::size_t k = 0; k < n; ++k) ++count[keys[k] + 1];
  for (std::size_t k = 0; k < nKeys; ++k) count[k + 1] += count[k];
  other.resize(n);
  for (std::size_t k = 0; k < n; ++k) other[count[keys[k]]++] = indices[k];
  std::ranges::copy(std::span(other).first(n), indices.begin());
}

template <int Dim>
void SpatialOrder<Dim>::Packer::pack(std::span<const Vec<Dim>> points,
                                     std::span<std::uint32_t> indices) {
  const std::size_t n = indices.size();
  if (n <= clusterSize) return;
  const std::span<const std::uint32_t> cell = indices;
  const Box<Dim> box = bulkOf<Dim>(points, cell, boundsOf<Dim>(points, cell));
  keys.resize(n);
  // Groups of consecutive places, of equal size on every level: all points, slabs, columns.
  std::size_t groupSize = n;
  double clustersLeft = static_cast<double>(n) / clusterSize;  // in a group
  for (int a = 0; a < Dim; ++a) {
    const double length = box.upper[a] - box.lower[a];
    const std::size_t nGroups = (n + groupSize - 1) / groupSize;
    // About one point a bin in the finest case.
    const auto nBins =
        static_cast<std::uint32_t>(std::clamp<std::size_t>(a == 0 ? 1024 : groupSize, 16, 4096));
    const double binsPerLength = length > 0 ? nBins / length : 0;
    for (std::size_t k = 0; k < n; ++k) {
      const auto group = static_cast<std::uint32_t>(k / groupSize);
      const double place = (points[indices[k]][a] - box.lower[a]) * binsPerLength;
      auto bin = static_cast<std::uint32_t>(std::clamp(place, 0.0, nBins - 1.0));
      if ((group & 1) != 0) bin = nBins - 1 - bin;  // serpentine: neighbours touch at their ends
      keys[k] = group * nBins + bin;
    }
    sortByKey(indices, nGroups * nBins);
    if (a == Dim - 1) break;
    // The next cut makes groups whose clusters are about cubic. A flat axis is not cut.
    double nSlabs = 1;
    if (length > 0) {
      double logVolume = std::log(length);
      for (int b = a + 1; b < Dim; ++b) {
        const double extent = box.upper[b] - box.lower[b];
        logVolume += std::log(std::max(extent, 1e-6 * length));
      }
      const double logEdge = (logVolume - std::log(clustersLeft)) / (Dim - a);
      nSlabs = std::clamp(std::round(std::exp(std::log(length) - logEdge)), 1.0, clustersLeft);
    }
    groupSize = clusterSize * static_cast<std::size_t>(std::ceil(clustersLeft / nSlabs));
    clustersLeft = static_cast<double>(groupSize / clusterSize);
  }
}

template <int Dim>
SpatialOrder<Dim>::SpatialOrder() = default;
template <int Dim>
SpatialOrder<Dim>::~SpatialOrder() = default;
template <int Dim>
SpatialOrder<Dim>::SpatialOrder(SpatialOrder&&) noexcept = default;
template <int Dim>
SpatialOrder<Dim>& SpatialOrder<Dim>::operator=(SpatialOrder&&) noexcept = default;

/// Sorts places [first, last) by the cells of a grid over their box, and notes the ranges that are
/// small enough for a Packer.
template <int Dim>
void SpatialOrder<Dim>::divide(std::size_t first, std::size_t last, int depth) {
  const std::size_t n = last - first;
  const auto leaveWhole = [&] {
    if (n > 0) cellEnds_.push_back(last);
  };
  if (n <= 2 * cellPoints<Dim> || depth == maxDepth) return leaveWhole();
  const auto indices = order_.subspan(first, n), cells = cell_.subspan(first, n);
  const auto sorted = sorted_.subspan(first, n);
  const Box<Dim> box = boundsOf<Dim>(points_, std::span<const std::uint32_t>(indices));
  const Serpentine<Dim> grid(box, static_cast<double>(n) / cellPoints<Dim>);
  const std::size_t nCells = grid.nCells(), before = starts_.size();
  if (nCells == 1) return leaveWhole();  // too few for two along some axis, or all in one place
  // A stable counting sort in as many parts as there are threads: its result is the same for any
  // number of parts.
  const std::size_t nParts =
      n >= worthThreads ? static_cast<std::size_t>(omp_get_max_threads()) : 1;
  starts_.resize(before + nParts * nCells, 0);
  std::uint32_t* const starts = starts_.data() + before;
  const auto forEachPart = [&](auto&& body) {
#pragma omp parallel for schedule(static, 1) if (nParts > 1)
    for (std::size_t part = 0; part < nParts; ++part)
      body(starts + part * nCells, part * n / nParts, (part + 1) * n / nParts);
  };
  forEachPart([&](std::uint32_t* count, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      cells[k] = grid.cellOf(points_[indices[k]]);
      ++count[cells[k]];
    }
  });
  std::uint32_t place = 0;
  for (std::size_t c = 0; c < nCells; ++c)
    for (std::size_t part = 0; part < nParts; ++part)
      place += std::exchange(starts[part * nCells + c], place);
  forEachPart([&](std::uint32_t* next, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) sorted[next[cells[k]]++] = indices[k];
  });
  forEachIndex(n, [&](std::size_t k) { indices[k] = sorted[k]; });
  // Where the last part has placed its points of a cell, the cell ends.
  std::size_t begin = 0;
  for (std::size_t c = 0; c < nCells; ++c) {
    const std::size_t end = starts_[before + (nParts - 1) * nCells + c];
    divide(first + begin, first + end, depth + 1);
    begin = end;
  }
  starts_.resize(before);
}

template <int Dim>
void SpatialOrder<Dim>::sort(std::span<const Vec<Dim>> points, std::span<std::uint32_t> order,
                             std::span<std::uint32_t> sorted, std::span<std::uint32_t> cell) {
  points_ = points;
  order_ = order;
  sorted_ = sorted;
  cell_ = cell;
  std::iota(order_.begin(), order_.end(), 0u);
  cellEnds_.clear();
  divide(0, points.size(), 0);
  const auto nThreads = static_cast<std::size_t>(omp_get_max_threads());
  if (packers_.size() < nThreads) packers_.resize(nThreads);
#pragma omp parallel for schedule(dynamic, 1) if (points.size() >= worthThreads)
  for (std::size_t c = 0; c < cellEnds_.size(); ++c) {
    const std::size_t first = c == 0 ? 0 : cellEnds_[c - 1];
    packers_[static_cast<std::size_t>(omp_get_thread_num())].pack(
        points_, order_.subspan(first, cellEnds_[c] - first));
  }
}

template class SpatialOrder<1>;
template class SpatialOrder<2>;
template class SpatialOrder<3>;

}  // namespace plenum
