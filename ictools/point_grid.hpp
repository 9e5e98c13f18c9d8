// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace plenum {

/// Points in cells, to which more may be added: answers who is near. Distances are to the nearest
/// periodic image. Queries may come from several threads, `insert` from one.
template <int Dim>
class PointGrid {
 public:
  /// `box` contains all points that will come [m]; `reach` is the largest distance asked for [m];
  /// `expected` is the number of points, for the number of cells only.
  PointGrid(const Box<Dim>& box, double reach, std::size_t expected) : box_(box), reach_(reach) {
    const double maxCells = 4 * static_cast<double>(expected) + 64;
    double edge = reach;
    const auto cellsAlong = [&](int a) {
      const double n = std::floor((box.upper[a] - box.lower[a]) / edge);
      return n < 1 ? 1.0 : n;
    };
    double total = 0;
    while (true) {
      total = 1;
      for (int a = 0; a < Dim; ++a) total *= cellsAlong(a);
      if (total <= maxCells) break;
      edge *= 1.5;
    }
    for (int a = 0; a < Dim; ++a) shape_[a] = static_cast<int>(cellsAlong(a));
    head_.assign(static_cast<std::size_t>(total), none);
    next_.reserve(expected);
  }

  /// Of `points`, which must outlive the grid; none can be added.
  PointGrid(const Box<Dim>& box, double reach, std::span<const Vec<Dim>> points)
      : PointGrid(box, reach, points.size()) {
    given_ = points;
    for (const Vec<Dim>& x : points) link(x);
  }

  std::size_t size() const { return next_.size(); }
  const Vec<Dim>& operator[](std::size_t k) const { return given_.empty() ? added_[k] : given_[k]; }

  /// The point gets the next number, starting from 0.
  void insert(const Vec<Dim>& x) {
    assert(given_.empty());
    link(x);
    added_.push_back(x);
  }

  /// Calls visit(number, distance squared) for all points within `reach`, in no particular order.
  template <class Visit>
  void forEachNear(const Vec<Dim>& x, Visit&& visit) const {
    visitAxis(Dim - 1, cellOf(x), 0, x, visit);
  }

  /// Distance to the nearest point but `except` [m]; infinite if none is within `reach`.
  double nearest(const Vec<Dim>& x, std::size_t except = none) const {
    double best = std::numeric_limits<double>::infinity();
    forEachNear(x, [&](std::size_t k, double squared) {
      if (k != except) best = std::min(best, squared);
    });
    return std::sqrt(best);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  void link(const Vec<Dim>& x) {
    std::uint32_t& head = head_[indexOf(cellOf(x))];
    next_.push_back(head);
    head = static_cast<std::uint32_t>(next_.size() - 1);
  }

  std::array<int, Dim> cellOf(const Vec<Dim>& x) const {
    std::array<int, Dim> cell{};
    for (int a = 0; a < Dim; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      const double s = (x[a] - box_.lower[a]) / (box_.upper[a] - box_.lower[a]) * shape_[a];
      // In this order, so that NaN becomes 0 and points far away come into the range of int.
      const int last = shape_[a] - 1;
      cell[axis] = !(s > 0) ? 0 : s < last ? static_cast<int>(s) : last;
    }
    return cell;
  }

  std::size_t indexOf(const std::array<int, Dim>& cell) const {
    std::size_t index = 0;
    for (int a = Dim - 1; a >= 0; --a)
      index = index * static_cast<std::size_t>(shape_[a]) +
              static_cast<std::size_t>(cell[static_cast<std::size_t>(a)]);
    return index;
  }

  /// Cells along `a` and the axes before it, in the row of cells number `row` of the axes behind.
  template <class Visit>
  void visitAxis(int a, const std::array<int, Dim>& center, std::size_t row, const Vec<Dim>& x,
                 Visit& visit) const {
    const int middle = center[static_cast<std::size_t>(a)];
    const int n = shape_[a];
    const bool wraps = box_.isPeriodic(a) && n > 2;
    const int first = wraps ? middle - 1 : std::max(0, middle - 1);
    const int last = wraps ? middle + 1 : std::min(n - 1, middle + 1);
    for (int c = first; c <= last; ++c) {
      const int inside = c < 0 ? c + n : c >= n ? c - n : c;
      const std::size_t cell = row * static_cast<std::size_t>(n) + static_cast<std::size_t>(inside);
      if (a == 0)
        visitCell(cell, x, visit);
      else
        visitAxis(a - 1, center, cell, x, visit);
    }
  }

  template <class Visit>
  void visitCell(std::size_t cell, const Vec<Dim>& x, Visit& visit) const {
    for (std::uint32_t k = head_[cell]; k != none; k = next_[k]) {
      const Vec<Dim> way = (*this)[k] - x;
      const double squared = normSquared(isPeriodic_ ? box_.nearestImage(way) : way);
      if (squared <= reach_ * reach_) visit(static_cast<std::size_t>(k), squared);
    }
  }

  Box<Dim> box_;
  bool isPeriodic_ = box_.anyPeriodic();
  double reach_;
  struct Shape {
    std::array<int, Dim> n{};
    int& operator[](int a) { return n[static_cast<std::size_t>(a)]; }
    int operator[](int a) const { return n[static_cast<std::size_t>(a)]; }
  } shape_;
  std::vector<std::uint32_t> head_;
  std::vector<std::uint32_t> next_;
  std::span<const Vec<Dim>> given_;
  std::vector<Vec<Dim>> added_;
};

}  // namespace plenum
