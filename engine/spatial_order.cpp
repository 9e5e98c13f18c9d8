// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/spatial_order.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace plenum {

namespace {

/// Points of a full cell: 16 x 16 clusters in 2-D, 8 x 8 x 8 in 3-D.
template <int Dim>
constexpr std::size_t cellPoints = Dim == 3 ? 4096 : 2048;

constexpr int maxDepth = 12;  // then the points coincide, but for rounding

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

template <int Dim, class Index>
Box<Dim> boundsOf(std::span<const Vec<Dim>> points, std::span<const Index> indices) {
  Box<Dim> box = Box<Dim>::nothing();
  for (const Index i : indices) {
    const Vec<Dim>& x = points[i];
    for (int a = 0; a < Dim; ++a) {
      box.lower[a] = std::min(box.lower[a], x[a]);
      box.upper[a] = std::max(box.upper[a], x[a]);
    }
  }
  return box;
}

}  // namespace

/// Work space of `pack`, one a thread.
template <int Dim>
struct SpatialOrder<Dim>::Scratch {
  std::vector<std::uint32_t> key, other, count;

  /// Sorts `indices` by key[k] in [0, nKeys), stable; keys go along.
  void sortByKey(std::span<std::uint32_t> indices, std::size_t nKeys) {
    count.assign(nKeys + 1, 0);
    const std::size_t n = indices.size();
    for (std::size_t k = 0; k < n; ++k) ++count[key[k] + 1];
    for (std::size_t k = 0; k < nKeys; ++k) count[k + 1] += count[k];
    other.resize(n);
    for (std::size_t k = 0; k < n; ++k) other[count[key[k]]++] = indices[k];
    std::ranges::copy(std::span(other).first(n), indices.begin());
  }
};

/// Orders a range of at most a few cells' points by slabs, columns and the last axis.
template <int Dim>
void SpatialOrder<Dim>::pack(std::span<const Vec<Dim>> points, std::size_t first, std::size_t last,
                             Scratch& scratch) {
  const std::span<std::uint32_t> indices(order_.data() + first, last - first);
  const std::size_t n = indices.size();
  if (n <= clusterSize) return;
  const Box<Dim> box = boundsOf<Dim, std::uint32_t>(points, indices);
  const double nClusters = static_cast<double>(n) / clusterSize;
  scratch.key.resize(n);

  // Groups of consecutive places, of equal size on every level: all points, slabs, columns.
  std::size_t groupSize = n;
  double clustersLeft = nClusters;  // in a group
  for (int a = 0; a < Dim; ++a) {
    const double length = box.upper[a] - box.lower[a];
    const std::size_t nGroups = (n + groupSize - 1) / groupSize;
    // About one point a bin in the finest case.
    const auto nBins =
        static_cast<std::uint32_t>(std::clamp<std::size_t>(a == 0 ? 1024 : groupSize, 16, 4096));
    const double binsPerLength = length > 0 ? nBins / length : 0;
    for (std::size_t k = 0; k < n; ++k) {
      const auto group = static_cast<std::uint32_t>(k / groupSize);
      auto bin = static_cast<std::uint32_t>((points[indices[k]][a] - box.lower[a]) * binsPerLength);
      bin = std::min(bin, nBins - 1);
      if ((group & 1) != 0) bin = nBins - 1 - bin;  // serpentine: neighbours touch at their ends
      scratch.key[k] = group * nBins + bin;
    }
    scratch.sortByKey(indices, nGroups * nBins);
    if (a == Dim - 1) break;
    // The next cut makes groups whose clusters are about cubic.
    double rest = 1;
    for (int b = a + 1; b < Dim; ++b) rest *= std::max(box.upper[b] - box.lower[b], 1e-300);
    const double edge = std::pow(std::max(length, 1e-300) * rest / clustersLeft, 1.0 / (Dim - a));
    const double nSlabs = std::clamp(std::round(length / edge), 1.0, clustersLeft);
    clustersLeft /= nSlabs;
    groupSize = clusterSize * static_cast<std::size_t>(std::ceil(clustersLeft));
    clustersLeft = static_cast<double>(groupSize / clusterSize);
  }
}

/// Sorts places [first, last) by the cells of a grid over their box, and notes the ranges that are
/// small enough for `pack`.
template <int Dim>
void SpatialOrder<Dim>::divide(std::span<const Vec<Dim>> points, std::size_t first,
                               std::size_t last, int depth) {
  const std::size_t n = last - first;
  if (n <= 2 * cellPoints<Dim> || depth == maxDepth) {
    if (n > 0) cellEnd_.push_back(last);
    return;
  }
  const std::span<std::uint32_t> indices(order_.data() + first, n);
  const Box<Dim> box = boundsOf<Dim, std::uint32_t>(points, indices);
  const Serpentine<Dim> grid(box, static_cast<double>(n) / cellPoints<Dim>);
  const std::size_t nCells = grid.nCells();
  std::vector<std::size_t> start(nCells + 1, 0);
  forEachIndex(n, [&](std::size_t k) { cell_[first + k] = grid.cellOf(points[indices[k]]); });
  for (std::size_t k = 0; k < n; ++k) ++start[cell_[first + k] + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (std::size_t k = 0; k < n; ++k) sorted_[first + next[cell_[first + k]]++] = indices[k];
  std::copy_n(sorted_.begin() + static_cast<std::ptrdiff_t>(first), n, indices.begin());
  for (std::size_t c = 0; c < nCells; ++c)
    divide(points, first + start[c], first + start[c + 1], depth + 1);
}

template <int Dim>
void SpatialOrder<Dim>::sort(std::span<const Vec<Dim>> points) {
  const std::size_t n = points.size();
  order_.resize(n);
  sorted_.resize(n);
  cell_.resize(n);
  std::iota(order_.begin(), order_.end(), 0u);
  cellEnd_.clear();
  divide(points, 0, n, 0);
#pragma omp parallel if (n >= worthThreads)
  {
    Scratch scratch;
#pragma omp for schedule(dynamic, 1)
    for (std::size_t c = 0; c < cellEnd_.size(); ++c)
      pack(points, c == 0 ? 0 : cellEnd_[c - 1], cellEnd_[c], scratch);
  }
}

template <int Dim>
std::size_t SpatialOrder<Dim>::bytes() const {
  return (order_.capacity() + sorted_.capacity() + cell_.capacity()) * sizeof(std::uint32_t);
}

template class SpatialOrder<1>;
template class SpatialOrder<2>;
template class SpatialOrder<3>;

}  // namespace plenum
