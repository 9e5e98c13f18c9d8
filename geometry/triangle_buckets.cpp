// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_buckets.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {
constexpr std::size_t entriesPerTriangle = 8;
}

TriangleBuckets::TriangleBuckets(std::span<const Box<2>> boxes) {
  for (const Box<2>& box : boxes) bounds_.extend(box);
  const Vec<2> extent = bounds_.extent();
  const double longest = std::max(extent[0], extent[1]);
  const auto n = static_cast<double>(boxes.size());
  // Long triangles would be in very many small cells.
  double edge = std::max(std::sqrt(extent[0] * extent[1] / n), longest / n);
  setEdge(edge);
  while (countEntries(boxes) > entriesPerTriangle * boxes.size() && edge < longest)
    setEdge(edge *= std::sqrt(2.0));

  const auto nCells = static_cast<std::size_t>(shape_[0] * shape_[1]);
  const auto forEachCell = [&](const Box<2>& box, auto&& visit) {
    const Cells cells = cellsOf(box);
    for (std::int64_t j = cells.first[1]; j <= cells.last[1]; ++j)
      for (std::int64_t i = cells.first[0]; i <= cells.last[0]; ++i)
        visit(static_cast<std::size_t>(j * shape_[0] + i));
  };
  first_.assign(nCells + 1, 0);
  for (const Box<2>& box : boxes) forEachCell(box, [&](std::size_t cell) { ++first_[cell]; });
  std::uint32_t sum = 0;
  for (std::uint32_t& count : first_) count = sum += count;  // the end of each cell's list
  entries_.resize(sum);
  for (std::size_t t = boxes.size(); t-- > 0;)
    forEachCell(boxes[t], [&](std::size_t cell) {
      entries_[--first_[cell]] = static_cast<std::uint32_t>(t);
    });
}

std::span<const std::uint32_t> TriangleBuckets::at(const Vec<2>& x) const {
  if (!bounds_.contains(x)) return {};
  const auto cell = static_cast<std::size_t>(cellAlong(x[1], 1) * shape_[0] + cellAlong(x[0], 0));
  return std::span(entries_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
}

/// Grows with x whatever the rounding, so that a point in a box has a cell between those of the
/// box's ends.
std::int64_t TriangleBuckets::cellAlong(double x, int axis) const {
  const auto cell = static_cast<std::int64_t>((x - bounds_.lower[axis]) * inverseEdge_);
  return std::clamp<std::int64_t>(cell, 0, shape_[axis] - 1);
}

TriangleBuckets::Cells TriangleBuckets::cellsOf(const Box<2>& box) const {
  Cells cells{};
  for (int a = 0; a < 2; ++a) {
    cells.first[a] = cellAlong(box.lower[a], a);
    cells.last[a] = cellAlong(box.upper[a], a);
  }
  return cells;
}

void TriangleBuckets::setEdge(double edge) {
  inverseEdge_ = 1 / edge;
  for (int a = 0; a < 2; ++a)
    shape_[a] = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(std::ceil(bounds_.extent()[a] * inverseEdge_)));
}

std::size_t TriangleBuckets::countEntries(std::span<const Box<2>> boxes) const {
  std::size_t n = 0;
  for (const Box<2>& box : boxes) {
    const Cells cells = cellsOf(box);
    n += static_cast<std::size_t>((cells.last[0] - cells.first[0] + 1) *
                                  (cells.last[1] - cells.first[1] + 1));
  }
  return n;
}

}  // namespace plenum
