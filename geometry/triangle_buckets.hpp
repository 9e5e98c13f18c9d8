// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace plenum {

/// Triangles of a plane in a grid of square cells: answers which may be near a point. Each is
/// listed in all cells that its bounding box meets.
class TriangleBuckets {
 public:
  /// `boxes` are the bounding boxes of the triangles, `near` included. As many cells as triangles,
  /// or fewer, so that the lists have no more than a few entries a triangle.
  explicit TriangleBuckets(std::span<const Box<2>> boxes);

  /// Numbers, ascending, of all triangles whose box contains x, and of some others.
  std::span<const std::uint32_t> at(const Vec<2>& x) const;

 private:
  struct Cells {
    std::int64_t first[2];
    std::int64_t last[2];
  };
  std::int64_t cellAlong(double x, int axis) const;
  Cells cellsOf(const Box<2>& box) const;
  void setEdge(double edge);
  std::size_t countEntries(std::span<const Box<2>> boxes) const;

  Box<2> bounds_ = Box<2>::nothing();
  double inverseEdge_ = 1;
  std::int64_t shape_[2] = {1, 1};
  std::vector<std::uint32_t> first_;  ///< in entries_, a cell; one more at the end
  std::vector<std::uint32_t> entries_;
};

}  // namespace plenum
