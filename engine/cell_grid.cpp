// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/cell_grid.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

template <int Dim>
void CellGrid<Dim>::reshape(const Box<Dim>& box, double radius, std::size_t maxCells) {
  box_ = box;
  const auto cellsAlong = [&](int a, double edge) {
    const double n = std::floor((box.upper[a] - box.lower[a]) / edge);
    return std::clamp(n, 1.0, static_cast<double>(maxCells));
  };
  double edge = radius;
  const auto product = [&] {
    double n = 1;
    for (int a = 0; a < Dim; ++a) n *= cellsAlong(a, edge);
    return n;
  };
  while (product() > static_cast<double>(maxCells)) edge *= 1.26;  // twice the volume in 3-D

  nCells_ = 1;
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    shape_[axis] = static_cast<int>(cellsAlong(a, edge));
    nCells_ *= static_cast<std::size_t>(shape_[axis]);
    const double length = box.upper[a] - box.lower[a];
    cellsPerLength_[a] = length > 0 ? shape_[axis] / length : 0;
  }
}

template <int Dim>
void CellGrid<Dim>::sort(std::span<const Vec<Dim>> points) {
  const std::size_t n = points.size();
  start_.assign(nCells_ + 1, 0);
  order_.resize(n);
  cells_.resize(n);
  forEachIndex(n, [&](std::size_t i) {
    cells_[i] = static_cast<std::uint32_t>(indexOf(cellOf(points[i])));
  });
  for (std::size_t i = 0; i < n; ++i) ++start_[cells_[i] + 1];
  for (std::size_t c = 0; c < nCells_; ++c) start_[c + 1] += start_[c];
  // start_[c] serves as the next free place of cell c and is shifted back afterwards.
  for (std::size_t i = 0; i < n; ++i) order_[start_[cells_[i]]++] = static_cast<std::uint32_t>(i);
  for (std::size_t c = nCells_; c > 0; --c) start_[c] = start_[c - 1];
  start_[0] = 0;
}

template class CellGrid<1>;
template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace plenum
