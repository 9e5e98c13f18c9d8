// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/containment.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

template <int Dim>
Containment<Dim>::Containment(std::span<const FluidFill<Dim>> fluids, std::size_t k,
                              const Box<Dim>& domain, double margin)
    : domain_(domain), margin_(margin) {
  if (fluids[k].region) inside_.push_back(fluids[k].region);
  for (std::size_t earlier = 0; earlier < k; ++earlier)
    if (fluids[earlier].region) outside_.push_back(fluids[earlier].region);
}

/// The surface that is nearest, or furthest on the wrong side; signed distances as of a region that
/// is allowed.
template <int Dim>
SurfacePoint<Dim> Containment<Dim>::nearestSurface(const Vec<Dim>& x) const {
  SurfacePoint<Dim> worst;
  worst.signedDistance = -std::numeric_limits<double>::infinity();
  for (const auto& region : inside_) {
    const SurfacePoint<Dim> hit = region->closest(x);
    if (hit.signedDistance > worst.signedDistance) worst = hit;
  }
  for (const auto& region : outside_) {
    SurfacePoint<Dim> hit = region->closest(x);
    hit.normal = -hit.normal;
    hit.signedDistance = -hit.signedDistance;
    if (hit.signedDistance > worst.signedDistance) worst = hit;
  }
  return worst;
}

template <int Dim>
bool Containment<Dim>::isPeriodicFace(const Vec<Dim>& foot) const {
  for (int a = 0; a < Dim; ++a) {
    if (!domain_.isPeriodic(a)) continue;
    const double near = 1e-9 * (domain_.upper[a] - domain_.lower[a]);
    if (std::abs(foot[a] - domain_.lower[a]) <= near ||
        std::abs(foot[a] - domain_.upper[a]) <= near)
      return true;
  }
  return false;
}

template <int Dim>
Kept<Dim> Containment<Dim>::keep(const Vec<Dim>& point, const Vec<Dim>& before) const {
  Vec<Dim> x = domain_.wrap(point);
  constexpr int maxMoves = 4;  // corners of three surfaces, and one to see that it is well
  for (int move = 0; move < maxMoves; ++move) {
    const SurfacePoint<Dim> hit = nearestSurface(x);
    const double depth = -hit.signedDistance;
    if (depth >= margin_ * (1 - 1e-9)) return {x, std::max(depth - margin_, 0.0)};
    if (depth >= 0 && isPeriodicFace(hit.point)) return {x, depth};
    x = domain_.wrap(hit.point - margin_ * hit.normal);
  }
  return {before, 0};
}

template <int Dim>
void Containment<Dim>::keep(std::span<const Vec<Dim>> points, std::span<const Vec<Dim>> before,
                            std::span<Kept<Dim>> kept) const {
  constexpr std::size_t batch = 256;
  parallelFor((points.size() + batch - 1) / batch, [&](std::size_t b) {
    const std::size_t end = std::min(points.size(), (b + 1) * batch);
    for (std::size_t i = b * batch; i < end; ++i) kept[i] = keep(points[i], before[i]);
  });
}

template class Containment<1>;
template class Containment<2>;
template class Containment<3>;

}  // namespace plenum
