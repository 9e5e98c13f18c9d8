// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/descent.hpp"

#include "geometry/half_spaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace plenum {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

template Vec<1> descend<1>(const CommonRegion<1>&, const Vec<1>&, const Vec<1>&, double);
template Vec<2> descend<2>(const CommonRegion<2>&, const Vec<2>&, const Vec<2>&, double);
template Vec<3> descend<3>(const CommonRegion<3>&, const Vec<3>&, const Vec<3>&, double);

}  // namespace plenum
