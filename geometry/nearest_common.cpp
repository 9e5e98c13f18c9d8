// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearest_common.hpp"

#include "geometry/descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

  /// Where the descent ended, if that is in the region.
  std::optional<Vec<Dim>> descendFrom(const Vec<Dim>& start, double reach) {
    const Vec<Dim> end = descend(region_, x_, start, reach);
    if (region_.value(end) > region_.resolution()) return std::nullopt;
    minima_.push_back(end);
    offer(end);
    return end;
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

  static bool isNear(const Cell& cell, const std::vector<Vec<Dim>>& places) {
    return std::any_of(places.begin(), places.end(), [&](const Vec<Dim>& p) {
      return normSquared(p - cell.center) < 9 * cell.half * cell.half;
    });
  }

  bool mayHoldNearer(const Cell& cell) const {
    return cell.value <= std::sqrt(double(Dim)) * cell.half + region_.resolution() &&
           lowerBound(cell) < distance_ * (1 - 1e-9);
  }

  std::vector<Cell> children(const std::vector<Cell>& cells) const;
  bool isSeam(const Cell& cell) const;
  void descendFromEach(const std::vector<Cell>& cells);

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

/// Two parts only touch in the cell: at its centre their distances cancel and their normals are
/// opposite, and at its corners the distances have no negative sum. One of the two is then positive
/// everywhere but on the seam, and the region has no interior.
template <int Dim>
bool Search<Dim>::isSeam(const Cell& cell) const {
  constexpr double opposite = -1 + 1e-9;
  const double zero = 4 * region_.resolution();
  const std::vector<Part<Dim>>& parts = region_.parts();
  std::vector<SurfacePoint<Dim>> hits;
  for (const Part<Dim>& part : parts) hits.push_back(part.closest(cell.center));
  const auto touchAtCenter = [&](std::size_t i, std::size_t j) {
    return std::abs(hits[i].signedDistance + hits[j].signedDistance) <= zero &&
           dot(hits[i].normal, hits[j].normal) < opposite;
  };
  const auto overlapNowhere = [&](std::size_t i, std::size_t j) {
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      Vec<Dim> y = cell.center;
      for (int a = 0; a < Dim; ++a) y[a] += ((corner >> a) & 1 ? 1 : -1) * cell.half;
      if (parts[i].closest(y).signedDistance + parts[j].closest(y).signedDistance < -zero)
        return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (touchAtCenter(i, j) && overlapNowhere(i, j)) return true;
  return false;
}

template <int Dim>
void Search<Dim>::branchAndBound() {
  // Surfaces that almost coincide keep whole sheets of cells alive: the number of cells is limited,
  // and each that is left is followed to its local minimum, unless one was found in its
  // neighbourhood. Seams are taken out once cells are small beside the distance sought.
  constexpr std::size_t maxCells = Dim == 3 ? 1000 : 200;
  constexpr double finest = 1. / 64;
  constexpr double seams = 1. / 8;
  const auto nearer = [this](const Cell& a, const Cell& b) {
    return lowerBound(a) < lowerBound(b);
  };
  // What is left of the cells in the end grows with the difference to the true distance: the best
  // point is moved to its local minimum now and whenever a better one is found.
  if (distance_ < infinity) descendFrom(point_, 0.1 * distance_);
  std::vector<Cell> cells{{x_, distance_, region_.value(x_)}};
  while (!cells.empty() && cells.size() < maxCells && cells.front().half > finest * distance_) {
    cells = children(cells);
    if (!cells.empty() && cells.front().half <= seams * distance_)
      std::erase_if(cells, [this](const Cell& cell) { return isSeam(cell); });
    if (cells.empty()) break;
    const Cell nearest = *std::min_element(cells.begin(), cells.end(), nearer);
    if (!isNear(nearest, minima_)) descendFrom(nearest.center, 2 * nearest.half);
    const double before = distance_;
    for (const Cell& cell : cells)
      if (cell.value < -region_.resolution()) offer(cell.center);
    if (distance_ < before) descendFrom(point_, 0.1 * distance_);
    std::erase_if(cells, [this](const Cell& cell) { return !mayHoldNearer(cell); });
  }
  std::sort(cells.begin(), cells.end(), nearer);
  descendFromEach(cells);
  descendFrom(point_, 0.1 * distance_);
}

/// From cells sorted with the most promising first. A descent speaks for the neighbours of its
/// start, and one that ends in the best point for twice as far around that.
template <int Dim>
void Search<Dim>::descendFromEach(const std::vector<Cell>& cells) {
  std::vector<Vec<Dim>> starts;
  double explained = 0;
  for (const Cell& cell : cells) {
    if (lowerBound(cell) >= distance_) break;
    if (isNear(cell, minima_) || isNear(cell, starts)) continue;
    if (norm(cell.center - point_) < explained) continue;
    const double before = distance_;
    const std::optional<Vec<Dim>> end = descendFrom(cell.center, 2 * cell.half);
    starts.push_back(cell.center);
    if (distance_ < before) explained = 0;
    if (end && norm(*end - point_) < 1e-6 * distance_)
      explained = std::max(explained, 2 * norm(cell.center - point_));
  }
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
