// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plenum {

/// A grid of cells over a box. Points are sorted by cell (counting sort, stable), so that the
/// points near a place are a few contiguous ranges of that order.
///
/// Points beyond the box along open axes count to the nearest edge cell: this never loses a pair,
/// because clamping moves no two points apart.
template <int Dim>
class CellGrid {
 public:
  using Cell = std::array<int, Dim>;

  /// Cells of at least `radius` [m], so that all points within `radius` of a point lie in its cell
  /// or in the adjacent ones. Uses larger cells where the box would need more than `maxCells`.
  void reshape(const Box<Dim>& box, double radius, std::size_t maxCells);

  /// Sorts `points`; order()[k] is then the index of the point in place k.
  void sort(std::span<const Vec<Dim>> points);

  std::span<const std::uint32_t> order() const { return order_; }
  std::size_t nCells() const { return nCells_; }

  /// Calls visit(first, last) for ranges of places that together hold every point within `radius`
  /// of x; no place comes twice.
  template <class Visit>
  void forEachRange(const Vec<Dim>& x, Visit&& visit) const;

 private:
  /// Cells along one axis that a search visits, as at most two runs (periodic axes wrap).
  struct Runs {
    std::array<int, 2> first{};
    std::array<int, 2> last{};  // included
    int count = 0;
  };

  Cell cellOf(const Vec<Dim>& x) const;
  std::size_t indexOf(const Cell& cell) const;
  Runs runsAround(int cell, int axis) const;

  Box<Dim> box_;
  Cell shape_{};
  std::size_t nCells_ = 0;
  Vec<Dim> cellsPerLength_{};
  std::vector<std::uint32_t> start_;  // first place of each cell; length nCells + 1
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> cells_;  // cell of each point
};

template <int Dim>
typename CellGrid<Dim>::Cell CellGrid<Dim>::cellOf(const Vec<Dim>& x) const {
  Cell cell;
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double s = (x[a] - box_.lower[a]) * cellsPerLength_[a];
    // Written so that NaN ends in cell 0 instead of an undefined conversion.
    const double clamped = s > 0 ? (s < shape_[axis] - 1 ? s : shape_[axis] - 1) : 0.0;
    cell[axis] = static_cast<int>(clamped);
  }
  return cell;
}

template <int Dim>
std::size_t CellGrid<Dim>::indexOf(const Cell& cell) const {
  std::size_t index = 0;
  for (std::size_t axis = Dim; axis-- > 0;)
    index = index * static_cast<std::size_t>(shape_[axis]) + static_cast<std::size_t>(cell[axis]);
  return index;
}

template <int Dim>
typename CellGrid<Dim>::Runs CellGrid<Dim>::runsAround(int cell, int axis) const {
  const int n = shape_[static_cast<std::size_t>(axis)];
  Runs runs;
  const auto add = [&runs](int first, int last) {
    runs.first[static_cast<std::size_t>(runs.count)] = first;
    runs.last[static_cast<std::size_t>(runs.count)] = last;
    ++runs.count;
  };
  if (!box_.isPeriodic(axis)) {
    add(cell > 0 ? cell - 1 : 0, cell < n - 1 ? cell + 1 : n - 1);
  } else if (n <= 3) {
    add(0, n - 1);
  } else if (cell == 0) {
    add(0, 1);
    add(n - 1, n - 1);
  } else if (cell == n - 1) {
    add(n - 2, n - 1);
    add(0, 0);
  } else {
    add(cell - 1, cell + 1);
  }
  return runs;
}

template <int Dim>
template <class Visit>
void CellGrid<Dim>::forEachRange(const Vec<Dim>& x, Visit&& visit) const {
  const Cell center = cellOf(x);
  std::array<Runs, Dim> runs;
  for (int a = 0; a < Dim; ++a)
    runs[static_cast<std::size_t>(a)] = runsAround(center[static_cast<std::size_t>(a)], a);

  // A row of cells along the first axis is contiguous: one range a run of cells.
  const auto visitRow = [&](Cell cell) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(runs[0].count); ++k) {
      cell[0] = runs[0].first[k];
      const std::size_t first = indexOf(cell);
      const auto length = static_cast<std::size_t>(runs[0].last[k] - runs[0].first[k]);
      const std::uint32_t begin = start_[first], end = start_[first + length + 1];
      if (begin < end) visit(begin, end);
    }
  };
  const auto forEachCell = [&](std::size_t axis, auto&& visitCell) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(runs[axis].count); ++k)
      for (int c = runs[axis].first[k]; c <= runs[axis].last[k]; ++c) visitCell(c);
  };
  Cell cell = center;
  if constexpr (Dim == 1) {
    visitRow(cell);
  } else if constexpr (Dim == 2) {
    forEachCell(1, [&](int y) {
      cell[1] = y;
      visitRow(cell);
    });
  } else {
    forEachCell(2, [&](int z) {
      cell[2] = z;
      forEachCell(1, [&](int y) {
        cell[1] = y;
        visitRow(cell);
      });
    });
  }
}

extern template class CellGrid<1>;
extern template class CellGrid<2>;
extern template class CellGrid<3>;

}  // namespace plenum
