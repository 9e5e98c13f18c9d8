// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/cell_grid.hpp"
#include "particles/box.hpp"

#include <span>
#include <vector>

namespace plenum {

/// Points in a grid of cells, with a search around any place.
template <int Dim>
class PointSearch {
 public:
  PointSearch(std::span<const Vec<Dim>> points, const Box<Dim>& domain, double radius)
      : domain_(domain), radiusSquared_(radius * radius) {
    std::vector<Vec<Dim>> wrapped;
    wrapped.reserve(points.size());
    for (const Vec<Dim>& x : points) wrapped.push_back(domain.wrap(x));
    grid_.reshape(domain, radius, 4 * points.size() + 64);
    grid_.sort(wrapped);
    points_.reserve(points.size());
    for (const std::uint32_t j : grid_.order()) points_.push_back(wrapped[j]);
  }

  /// visit(index, x_index - x, distance squared) for all points within the radius.
  template <class Visit>
  void around(const Vec<Dim>& x, Visit&& visit) const {
    grid_.forEachRange(domain_.wrap(x), [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t place = first; place < last; ++place) {
        const Vec<Dim> d = domain_.nearestImage(points_[place] - x);
        const double d2 = normSquared(d);
        if (d2 < radiusSquared_) visit(grid_.order()[place], d, d2);
      }
    });
  }

 private:
  Box<Dim> domain_;
  double radiusSquared_;
  std::vector<Vec<Dim>> points_;  // in the order of the cells
  CellGrid<Dim> grid_;
};

}  // namespace plenum
