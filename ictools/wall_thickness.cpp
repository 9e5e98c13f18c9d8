// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/wall_thickness.hpp"

#include "ictools/thin_parts.hpp"
#include "particles/parallel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The solids of all walls as one.
template <int Dim>
class AllSolids {
 public:
  AllSolids(const std::vector<WallFill<Dim>>& walls, const SceneFrame<Dim>& frame)
      : walls_(walls), domain_(frame.domain), gap_(surfaceRoundOff * frame.spacing) {
    for (const auto& wall : walls) gap_ += wall.solid.geometry->tolerance();
  }

  /// How far two surfaces may be apart that are meant to be one [m].
  double gap() const { return gap_; }

  /// Depth behind the nearest surface [m]; negative outside of all.
  double depth(const Vec<Dim>& x) const { return depthIn(deepest(x), x); }

  /// Unit normal out of the solid that reaches nearest to `x`.
  Vec<Dim> normal(const Vec<Dim>& x) const {
    const WallSolid<Dim>& solid = deepest(x);
    return solid.normal(solid.geometry->closest(domain_.wrap(x)));
  }

 private:
  double depthIn(const WallSolid<Dim>& solid, const Vec<Dim>& x) const {
    return solid.depth(solid.geometry->signedDistance(domain_.wrap(x)));
  }

  const WallSolid<Dim>& deepest(const Vec<Dim>& x) const {
    const WallSolid<Dim>* best = &walls_.front().solid;
    double depth = depthIn(*best, x);
    for (std::size_t w = 1; w < walls_.size(); ++w) {
      const double here = depthIn(walls_[w].solid, x);
      if (here <= depth) continue;
      depth = here;
      best = &walls_[w].solid;
    }
    return *best;
  }

  const std::vector<WallFill<Dim>>& walls_;
  const Box<Dim>& domain_;
  double gap_;
};

/// Way through the solids from the foot of `point`, against its normal; infinite if it is longer
/// than `longest` [m], ends at a surface that is not opposite, or starts at no free surface.
template <int Dim>
double wayThrough(const AllSolids<Dim>& solids, const WallPoint<Dim>& point, double longest,
                  double spacing) {
  const Vec<Dim> foot = point.position + point.depth * point.normal;
  const double step = spacing / 8;
  if (solids.depth(foot + 2 * solids.gap() * point.normal) > 0) return infinite;
  const auto at = [&](double way) { return foot - way * point.normal; };
  double inside = point.depth, outside = point.depth;
  for (double depth = point.depth; depth > -solids.gap();) {
    if (outside >= longest) return infinite;
    inside = outside;
    outside = inside + std::max(depth, step);  // a ball as large as the depth is solid
    depth = solids.depth(at(outside));
  }
  constexpr int halvings = 30;  // of a step, to far below round-off of d_ref
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (inside + outside);
    (solids.depth(at(middle)) > 0 ? inside : outside) = middle;
  }
  const bool isOpposite = dot(solids.normal(at(outside)), point.normal) < oppositeCosine;
  return isOpposite ? outside + solids.gap() : infinite;  // as files are off by so much
}

}  // namespace

template <int Dim>
ThroughThickness<Dim> throughThickness(const std::vector<WallFill<Dim>>& walls, std::size_t w,
                                       const SceneFrame<Dim>& frame) {
  const AllSolids<Dim> solids(walls, frame);
  const WallFill<Dim>& wall = walls[w];
  std::vector<WallPoint<Dim>> points;  // the first layer
  for (const auto& point : wall.points)
    if (point.depth <= wall.spacing) points.push_back(point);
  std::vector<double> ways(points.size());
  constexpr std::size_t batch = 256;
  parallelFor((points.size() + batch - 1) / batch, [&](std::size_t b) {
    for (std::size_t k = b * batch; k < std::min(points.size(), (b + 1) * batch); ++k)
      ways[k] = wayThrough(solids, points[k], wall.layers * wall.spacing, wall.spacing);
  });
  ThroughThickness<Dim> thinnest{infinite, {}};
  for (std::size_t k = 0; k < points.size(); ++k)
    if (ways[k] < thinnest.thickness)
      thinnest = {ways[k], points[k].position + points[k].depth * points[k].normal};
  return thinnest;
}

template <int Dim>
void measureThickness(std::vector<WallFill<Dim>>& walls, const SceneFrame<Dim>& frame,
                      const Warn& warn) {
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const ThroughThickness<Dim> through = throughThickness(walls, w, frame);
    if (!(through.thickness < walls[w].thickness)) continue;
    walls[w].thickness = through.thickness;
    const double support = walls[w].support;
    if (through.thickness > support - surfaceRoundOff * frame.spacing) continue;
    warn(fmt::format(
        "wall \"{}\" is only {:g} m thick at ({:g}), less than the kernel's support of {:g} m, so "
        "that fluid on its two sides would meet through it: plenum-sph will refuse this set; make "
        "the solid thicker, or the spacing {:.4g} m or less",
        walls[w].settings.name, through.thickness, fmt::join(through.at.components, ", "), support,
        0.9999 * frame.spacing * through.thickness / support));
  }
}

template ThroughThickness<1> throughThickness(const std::vector<WallFill<1>>&, std::size_t,
                                              const SceneFrame<1>&);
template void measureThickness(std::vector<WallFill<1>>&, const SceneFrame<1>&, const Warn&);
template ThroughThickness<2> throughThickness(const std::vector<WallFill<2>>&, std::size_t,
                                              const SceneFrame<2>&);
template void measureThickness(std::vector<WallFill<2>>&, const SceneFrame<2>&, const Warn&);
template ThroughThickness<3> throughThickness(const std::vector<WallFill<3>>&, std::size_t,
                                              const SceneFrame<3>&);
template void measureThickness(std::vector<WallFill<3>>&, const SceneFrame<3>&, const Warn&);

}  // namespace plenum
