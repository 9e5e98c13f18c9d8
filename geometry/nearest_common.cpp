// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearest_common.hpp"

#include "geometry/descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The shortest way out of x: best point found so far, and what is proven about the rest.
template <int Dim>
class Search {
 public:
  Search(const CommonRegion<Dim>& region, const Vec<Dim>& x) : region_(region), x_(x) {}

  double distance() const { return distance_; }
  const Vec<Dim>& point() const { return point_; }

  /// Takes `p` if it belongs to the region and is nearer than the best so far.
  void offer(const Vec<Dim>& p) {
    const double distance = norm(p - x_);
    if (!(distance < distance_) || region_.value(p) > region_.resolution()) return;
    if (!region_.touchesInterior(p)) return;
    distance_ = distance;
    point_ = p;
  }

  void descendFrom(const Vec<Dim>& start, double reach) {
    const Vec<Dim> end = descend(region_, x_, start, reach);
    if (region_.value(end) > region_.resolution()) return;
    minima_.push_back(end);
    offer(end);
  }

  /// Where the way from x to an inner point enters the region.
  void enterTowards(const Vec<Dim>& inner) {
    Vec<Dim> outside = x_;
    Vec<Dim> inside = inner;
    for (int k = 0; k < 100 && norm(outside - inside) > region_.resolution(); ++k) {
      const Vec<Dim> middle = 0.5 * (outside + inside);
      (region_.value(middle) > 0 ? outside : inside) = middle;
    }
    offer(inside);
    descendFrom(inside, 0.25 * norm(inside - x_));
  }

  void branchAndBound();

 private:
  struct Cell {
    Vec<Dim> center;
    double half;
    double value;
  };

  double lowerBound(const Cell& cell) const {
    double sum = 0;
    for (int a = 0; a < Dim; ++a) {
      const double gap = std::max(0., std::abs(cell.center[a] - x_[a]) - cell.half);
      sum += gap * gap;
    }
    return std::sqrt(sum);
  }

  bool isNearMinimum(const Cell& cell) const {
    return std::any_of(minima_.begin(), minima_.end(), [&](const Vec<Dim>& p) {
      return normSquared(p - cell.center) < 9 * cell.half * cell.half;
    });
  }

  bool mayHoldNearer(const Cell& cell) const {
    return cell.value <= std::sqrt(double(Dim)) * cell.half + region_.resolution() &&
           lowerBound(cell) < distance_ * (1 - 1e-9);
  }

  std::vector<Cell> children(const std::vector<Cell>& cells) const;

  const CommonRegion<Dim>& region_;
  Vec<Dim> x_;
  Vec<Dim> point_{};
  double distance_ = infinity;
  std::vector<Vec<Dim>> minima_;  ///< where descents have ended
};

template <int Dim>
auto Search<Dim>::children(const std::vector<Cell>& cells) const -> std::vector<Cell> {
  std::vector<Cell> result;
  for (const Cell& cell : cells)
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      Cell child{cell.center, 0.5 * cell.half, 0};
      for (int a = 0; a < Dim; ++a) child.center[a] += ((corner >> a) & 1 ? 1 : -1) * child.half;
      if (lowerBound(child) >= distance_) continue;
      child.value = region_.value(child.center);
      if (mayHoldNearer(child)) result.push_back(child);
    }
  return result;
}

template <int Dim>
void Search<Dim>::branchAndBound() {
  // Coincident surfaces keep whole sheets of cells alive: the number of cells is limited, and each
  // that is left is followed to its local minimum, unless one was found in its neighbourhood.
  constexpr std::size_t maxCells = Dim == 3 ? 1000 : 200;
  constexpr double finest = 1. / 64;
  const auto nearer = [this](const Cell& a, const Cell& b) {
    return lowerBound(a) < lowerBound(b);
  };
  std::vector<Cell> cells{{x_, distance_, region_.value(x_)}};
  while (!cells.empty() && cells.size() < maxCells && cells.front().half > finest * distance_) {
    cells = children(cells);
    if (cells.empty()) return;
    const Cell nearest = *std::min_element(cells.begin(), cells.end(), nearer);
    if (!isNearMinimum(nearest)) descendFrom(nearest.center, 2 * nearest.half);
    for (const Cell& cell : cells)
      if (cell.value <= 0) offer(cell.center);
    std::erase_if(cells, [this](const Cell& cell) { return !mayHoldNearer(cell); });
  }
  std::sort(cells.begin(), cells.end(), nearer);
  for (const Cell& cell : cells) {
    if (lowerBound(cell) >= distance_) break;
    if (!isNearMinimum(cell)) descendFrom(cell.center, 2 * cell.half);
  }
  descendFrom(point_, 0.1 * distance_);
}

}  // namespace

template <int Dim>
Vec<Dim> nearestCommonPoint(const CommonRegion<Dim>& region, const Vec<Dim>& x,
                            const Vec<Dim>& interior) {
  Search<Dim> search(region, x);
  for (const Part<Dim>& part : region.parts()) {
    const SurfacePoint<Dim> hit = part.closest(x);
    search.descendFrom(hit.point, 0.25 * std::abs(hit.signedDistance) + 1e3 * region.resolution());
  }
  search.enterTowards(interior);
  search.branchAndBound();
  return search.distance() < infinity ? search.point() : interior;
}

template Vec<1> nearestCommonPoint<1>(const CommonRegion<1>&, const Vec<1>&, const Vec<1>&);
template Vec<2> nearestCommonPoint<2>(const CommonRegion<2>&, const Vec<2>&, const Vec<2>&);
template Vec<3> nearestCommonPoint<3>(const CommonRegion<3>&, const Vec<3>&, const Vec<3>&);
}  // namespace plenum
