// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearest_common.hpp"

#include <algorithm>
#include <array>
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

/// Constraints value + normal . (z - y) <= 0, the eight that matter most.
template <int Dim>
struct Constraints {
  static constexpr int most = 8;
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
  double violation = infinity;  ///< of the worst constraint afterwards [m]
};

/// Projects onto the constraints `active` taken as equations (Gaussian elimination with pivots);
/// false if they are dependent or if one would have to pull.
template <int Dim>
bool projectOnto(const Constraints<Dim>& c, std::span<const std::size_t> active,
                 Projection<Dim>& result) {
  const std::size_t n = active.size();
  std::array<std::array<double, 4>, 3> m{};
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
  result.violation = 0;
  for (std::size_t k = 0; k < std::size_t(c.n); ++k)
    result.violation = std::max(result.violation, c.value[k] + dot(c.normal[k], result.shift));
  return true;
}

/// Tries every set of at most `Dim` active constraints. Where none satisfies all: the one that
/// comes nearest to it.
template <int Dim>
Projection<Dim> project(const Constraints<Dim>& c, double zero) {
  Projection<Dim> best;
  std::array<std::size_t, 3> active{};
  const auto solved = [&](std::size_t n) {
    Projection<Dim> result;
    if (projectOnto(c, std::span<const std::size_t>(active).first(n), result) &&
        result.violation < best.violation)
      best = result;
    return best.violation <= zero;
  };
  if (solved(0)) return best;
  const auto n = std::size_t(c.n);
  for (active[0] = 0; active[0] < n; ++active[0])
    if (solved(1)) return best;
  if constexpr (Dim >= 2)
    for (active[0] = 0; active[0] < n; ++active[0])
      for (active[1] = 0; active[1] < active[0]; ++active[1])
        if (solved(2)) return best;
  if constexpr (Dim >= 3)
    for (active[0] = 0; active[0] < n; ++active[0])
      for (active[1] = 0; active[1] < active[0]; ++active[1])
        for (active[2] = 0; active[2] < active[1]; ++active[2])
          if (solved(3)) return best;
  return best;
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

/// All parts at one point.
template <int Dim>
struct Parts {
  Vec<Dim> at;
  std::vector<SurfacePoint<Dim>> hits;
  double value = -infinity;

  Parts(const CommonRegion<Dim>& region, const Vec<Dim>& y) : at(y) {
    hits.reserve(region.parts().size());
    for (const Part<Dim>& part : region.parts()) {
      hits.push_back(part.closest(y));
      value = std::max(value, hits.back().signedDistance);
    }
  }
};

/// The parts near a point as half-spaces. A part has one at the point itself, and others from
/// points nearby where they do not contradict it: near an edge of the part one is not enough.
template <int Dim>
class Bundle {
 public:
  explicit Bundle(double zero) : zero_(zero) {}

  /// Moves to `y`: its own half-spaces, and those of before that still hold.
  void moveTo(const Parts<Dim>& y) {
    const std::vector<Plane> before = std::move(planes_);
    planes_.clear();
    at_ = y;
    for (std::size_t part = 0; part < y.hits.size(); ++part)
      planes_.push_back({y.hits[part].signedDistance, y.hits[part].normal, part});
    for (const Plane& plane : before)
      add({plane.value + dot(plane.normal, y.at - from_), plane.normal, plane.part});
    from_ = y.at;
  }

  /// Adds what holds at another point; true if that was news.
  bool learnFrom(const Parts<Dim>& other) {
    const std::size_t n = planes_.size();
    for (std::size_t part = 0; part < other.hits.size(); ++part) {
      const SurfacePoint<Dim>& hit = other.hits[part];
      add({hit.signedDistance + dot(hit.normal, from_ - other.at), hit.normal, part});
    }
    return planes_.size() > n;
  }

  /// Those that matter most to the point at + shift.
  Constraints<Dim> constraints(const Vec<Dim>& shift) const {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < planes_.size(); ++k)
      order.push_back({-(planes_[k].value + dot(planes_[k].normal, shift)), k});
    std::sort(order.begin(), order.end());
    Constraints<Dim> c;
    c.n = static_cast<int>(std::min<std::size_t>(order.size(), Constraints<Dim>::most));
    for (std::size_t i = 0; i < std::size_t(c.n); ++i) {
      c.value[i] = -order[i].first;
      c.normal[i] = planes_[order[i].second].normal;
      c.part[i] = planes_[order[i].second].part;
    }
    return c;
  }

 private:
  struct Plane {
    double value;  ///< at the current point
    Vec<Dim> normal;
    std::size_t part;
  };

  void add(const Plane& plane) {
    if (plane.value > at_->hits[plane.part].signedDistance + zero_) return;
    for (const Plane& known : planes_)
      if (known.part == plane.part && dot(known.normal, plane.normal) > 0.9999) return;
    if (planes_.size() < 4 * at_->hits.size() + 4) planes_.push_back(plane);
  }

  double zero_;
  Vec<Dim> from_{};
  std::optional<Parts<Dim>> at_;
  std::vector<Plane> planes_;
};

}  // namespace

template <int Dim>
Vec<Dim> descend(const CommonRegion<Dim>& region, const Vec<Dim>& x, const Vec<Dim>& start,
                 double reach) {
  constexpr int maxSteps = 60;
  constexpr double penalty = 20;  // exact for wedges wider than about 6 degrees
  const double zero = 1e-4 * region.resolution();
  const auto merit = [&](const Parts<Dim>& y) {
    return norm(y.at - x) + penalty * std::max(0., y.value);
  };

  Parts<Dim> y(region, start);
  Bundle<Dim> bundle(zero);
  bundle.moveTo(y);
  double stepAlong = 1;  // 1 = the full way to x, what is right on flat surfaces
  double lastStep = infinity;
  for (int k = 0; k < maxSteps; ++k) {
    const Vec<Dim> towards = stepAlong * (x - y.at);
    const Constraints<Dim> constraints = bundle.constraints(towards);
    const Projection<Dim> onto = project(constraints, zero);
    Vec<Dim> step = towards + onto.shift;
    const double length = norm(step);
    if (length > reach) step *= reach / length;
    if (std::min(length, reach) < zero) break;

    const Parts<Dim> next(region, y.at + step);
    if (merit(next) > merit(y) && length > 0.5 * lastStep) {
      if (!bundle.learnFrom(next)) reach = 0.4 * std::min(reach, length);
      lastStep = 0;
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
    bundle.moveTo(y);
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
