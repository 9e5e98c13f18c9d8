// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearest_common.hpp"

#include <algorithm>
#include <array>
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
    offer(descend(region_, x_, start, reach));
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

  bool mayHoldNearer(const Cell& cell) const {
    return cell.value <= std::sqrt(double(Dim)) * cell.half + region_.resolution() &&
           lowerBound(cell) < distance_ * (1 - 1e-9);
  }

  std::vector<Cell> children(const std::vector<Cell>& cells) const;

  const CommonRegion<Dim>& region_;
  Vec<Dim> x_;
  Vec<Dim> point_{};
  double distance_ = infinity;
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
  // that is left is followed to its local minimum.
  constexpr std::size_t maxCells = Dim == 3 ? 1000 : 200;
  constexpr int maxLevels = 12;
  const auto nearer = [this](const Cell& a, const Cell& b) {
    return lowerBound(a) < lowerBound(b);
  };
  std::vector<Cell> cells{{x_, distance_, region_.value(x_)}};
  for (int level = 0; level < maxLevels && !cells.empty() && cells.size() < maxCells; ++level) {
    cells = children(cells);
    if (cells.empty()) return;
    const Cell nearest = *std::min_element(cells.begin(), cells.end(), nearer);
    descendFrom(nearest.center, 2 * nearest.half);
    for (const Cell& cell : cells)
      if (cell.value <= 0) offer(cell.center);
    std::erase_if(cells, [this](const Cell& cell) { return !mayHoldNearer(cell); });
  }
  std::sort(cells.begin(), cells.end(), nearer);
  for (const Cell& cell : cells) {
    if (lowerBound(cell) >= distance_) break;
    descendFrom(cell.center, 2 * cell.half);
  }
  if (distance_ < infinity) descendFrom(point_, 0.1 * distance_);
}

/// Constraints value + normal . (z - y) <= 0, at most six of them.
template <int Dim>
struct Constraints {
  static constexpr int most = 6;
  int n = 0;
  std::array<double, most> value{};  ///< at the point that is projected
  std::array<Vec<Dim>, most> normal{};
  std::array<std::size_t, most> part{};
};

/// The way onto the constraints: shift = -sum of lambda_k normal_k, lambda_k >= 0.
template <int Dim>
struct Projection {
  Vec<Dim> shift{};
  std::array<double, Constraints<Dim>::most> lambda{};
};

/// Projects onto the constraints `active` taken as equations (Gaussian elimination with pivots);
/// false if they are dependent, if one would have to pull, or if another constraint is violated.
template <int Dim>
bool projectOnto(const Constraints<Dim>& c, std::span<const std::size_t> active, double zero,
                 Projection<Dim>& result) {
  const std::size_t n = active.size();
  std::array<std::array<double, Dim + 1>, Dim> m{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = dot(c.normal[active[i]], c.normal[active[j]]);
    m[i][n] = c.value[active[i]];
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    if (std::abs(m[pivot][k]) < 1e-9) return false;
    std::swap(m[k], m[pivot]);
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = n + 1; j-- > k;) m[i][j] -= m[i][k] / m[k][k] * m[k][j];
  }
  result = {};
  for (std::size_t k = n; k-- > 0;) {
    double sum = m[k][n];
    for (std::size_t j = k + 1; j < n; ++j) sum -= m[k][j] * result.lambda[active[j]];
    const double lambda = sum / m[k][k];
    if (lambda < 0) return false;
    result.lambda[active[k]] = lambda;
    result.shift -= lambda * c.normal[active[k]];
  }
  for (std::size_t k = 0; k < std::size_t(c.n); ++k)
    if (c.value[k] + dot(c.normal[k], result.shift) > zero) return false;
  return true;
}

/// Tries every set of at most `Dim` active constraints; without a solution, onto the most violated.
template <int Dim>
Projection<Dim> project(const Constraints<Dim>& c, double zero) {
  Projection<Dim> result;
  std::array<std::size_t, 3> active{};
  const auto solved = [&](std::size_t n) {
    return projectOnto(c, std::span<const std::size_t>(active).first(n), zero, result);
  };
  if (solved(0)) return result;
  const auto n = std::size_t(c.n);
  for (active[0] = 0; active[0] < n; ++active[0])
    if (solved(1)) return result;
  if constexpr (Dim >= 2)
    for (active[0] = 0; active[0] < n; ++active[0])
      for (active[1] = 0; active[1] < active[0]; ++active[1])
        if (solved(2)) return result;
  if constexpr (Dim >= 3)
    for (active[0] = 0; active[0] < n; ++active[0])
      for (active[1] = 0; active[1] < active[0]; ++active[1])
        for (active[2] = 0; active[2] < active[1]; ++active[2])
          if (solved(3)) return result;
  result = {};
  result.lambda[0] = c.value[0];  // they come sorted, the most violated first
  result.shift = -c.value[0] * c.normal[0];
  return result;
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

namespace {

/// The parts at one point: what the linearisation needs.
template <int Dim>
struct Linearised {
  Vec<Dim> at;
  std::vector<SurfacePoint<Dim>> hits;
  double value = -infinity;

  Linearised(const CommonRegion<Dim>& region, const Vec<Dim>& y) : at(y) {
    hits.reserve(region.parts().size());
    for (const Part<Dim>& part : region.parts()) {
      hits.push_back(part.closest(y));
      value = std::max(value, hits.back().signedDistance);
    }
  }

  /// The constraints that matter most to the point at + shift.
  Constraints<Dim> constraints(const Vec<Dim>& shift) const {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < hits.size(); ++k)
      order.push_back({-(hits[k].signedDistance + dot(hits[k].normal, shift)), k});
    std::sort(order.begin(), order.end());
    Constraints<Dim> c;
    c.n = static_cast<int>(std::min<std::size_t>(order.size(), Constraints<Dim>::most));
    for (std::size_t i = 0; i < std::size_t(c.n); ++i) {
      c.value[i] = -order[i].first;
      c.part[i] = order[i].second;
      c.normal[i] = hits[c.part[i]].normal;
    }
    return c;
  }
};

}  // namespace

template <int Dim>
Vec<Dim> descend(const CommonRegion<Dim>& region, const Vec<Dim>& x, const Vec<Dim>& start,
                 double reach) {
  constexpr int maxSteps = 60;
  constexpr double penalty = 20;  // exact for wedges wider than about 6 degrees
  const double zero = 1e-4 * region.resolution();
  const auto merit = [&](const Linearised<Dim>& y) {
    return norm(y.at - x) + penalty * std::max(0., y.value);
  };

  Linearised<Dim> y(region, start);
  double stepAlong = 1;  // 1 = the full way to x, what is right on flat surfaces
  double lastStep = infinity;
  for (int k = 0; k < maxSteps; ++k) {
    const Vec<Dim> towards = stepAlong * (x - y.at);
    const Constraints<Dim> constraints = y.constraints(towards);
    const Projection<Dim> onto = project(constraints, zero);
    Vec<Dim> step = towards + onto.shift;
    const double length = norm(step);
    if (length > reach) step *= reach / length;
    if (std::min(length, reach) < zero) break;

    Linearised<Dim> next(region, y.at + step);
    if (merit(next) > merit(y) && length > 0.5 * lastStep) {
      reach = 0.4 * std::min(reach, length);
      lastStep = infinity;
      continue;
    }
    // Curvature: how the normals that balance x - y turn along the step.
    Vec<Dim> change = step;
    for (std::size_t i = 0; i < std::size_t(constraints.n); ++i) {
      const std::size_t part = constraints.part[i];
      change += onto.lambda[i] / stepAlong * (next.hits[part].normal - y.hits[part].normal);
    }
    const double along = dot(step, change);
    stepAlong = along > 0 ? std::clamp(normSquared(step) / along, 0.01, 10.) : 1;
    lastStep = length;
    y = next;
  }
  return y.at;
}

template Vec<1> nearestCommonPoint<1>(const CommonRegion<1>&, const Vec<1>&, const Vec<1>&);
template Vec<2> nearestCommonPoint<2>(const CommonRegion<2>&, const Vec<2>&, const Vec<2>&);
template Vec<3> nearestCommonPoint<3>(const CommonRegion<3>&, const Vec<3>&, const Vec<3>&);
template Vec<1> descend<1>(const CommonRegion<1>&, const Vec<1>&, const Vec<1>&, double);
template Vec<2> descend<2>(const CommonRegion<2>&, const Vec<2>&, const Vec<2>&, double);
template Vec<3> descend<3>(const CommonRegion<3>&, const Vec<3>&, const Vec<3>&, double);

}  // namespace plenum
