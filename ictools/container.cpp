// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/container.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

constexpr double samplesPerSpacing = 2;
constexpr double stepsPerSpacing = 32;
constexpr double marginInSpacings = 4;
constexpr double maxCount = 127;

/// Signed distance to the union of `regions`, exact within `near` [m] of a surface. Beyond it may
/// be too small in size where set operations have their edges, of the right sign: exact distances
/// to those take long.
template <int Dim>
double distanceNearSurface(const std::vector<GeometryPtr<Dim>>& regions, const Vec<Dim>& x,
                           double near) {
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& region : regions) {
    double own = region->distanceBound(x);
    if (std::abs(own) <= near) own = region->signedDistance(x);
    distance = std::min(distance, own);
  }
  return distance;
}

/// One row of samples along x. Far from the surface every count is clipped, and a distance tells
/// for how long that lasts.
template <int Dim>
void sampleRow(const std::vector<GeometryPtr<Dim>>& regions, const Box<Dim>& domain, double spacing,
               double step, Vec<Dim> x, std::span<std::int8_t> row) {
  const double start = x[0];
  for (std::size_t i = 0; i < row.size();) {
    x[0] = start + static_cast<double>(i) * spacing;
    const double distance = distanceNearSurface(regions, domain.wrap(x), std::sqrt(Dim) * spacing);
    const double count = std::clamp(std::round(distance / step), -maxCount, maxCount);
    const double beyond = (std::abs(distance) - (maxCount + 1) * step) / spacing;
    auto same = static_cast<std::size_t>(std::clamp(beyond, 1.0, static_cast<double>(row.size())));
    if (domain.isPeriodic(0)) same = 1;  // beyond the face the distance starts anew
    for (; same > 0 && i < row.size(); --same) row[i++] = static_cast<std::int8_t>(count);
  }
}

}  // namespace

template <int Dim>
std::vector<GeometryPtr<Dim>> containerRegions(const CaseNode& root, const CaseSettings& settings,
                                               const Regions<Dim>& regions,
                                               const std::vector<FluidFill<Dim>>& fluids,
                                               const SceneFrame<Dim>& frame) {
  if (!settings.container.empty()) {
    const CaseNode& node = at(root, "container");
    const GeometryPtr<Dim> region = regions.find(node);
    if (!frame.clipped(region->bounds()).isFinite())
      node.fail("is infinite; intersect it with a box");
    return {region};
  }
  std::vector<GeometryPtr<Dim>> starts;
  for (const auto& fluid : fluids) {
    if (!fluid.region) return {};
    starts.push_back(fluid.region);
  }
  return starts;
}

template <int Dim>
ContainerMap<Dim> containerMap(const std::vector<GeometryPtr<Dim>>& regions,
                               const SceneFrame<Dim>& frame) {
  ContainerMap<Dim> map;
  if (regions.empty()) return map;
  Box<Dim> box = Box<Dim>::nothing();
  for (const auto& region : regions) box.extend(region->bounds());
  box = frame.clipped(box.grown(marginInSpacings * frame.spacing));
  map.lower = box.lower;
  map.spacing = frame.spacing / samplesPerSpacing;
  map.step = frame.spacing / stepsPerSpacing;
  std::size_t nRows = 1;
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double cells = (box.upper[a] - box.lower[a]) / map.spacing;
    map.shape[axis] = std::max(1, static_cast<int>(std::ceil(cells - 1e-9)));
    if (a > 0) nRows *= static_cast<std::size_t>(map.shape[axis]);
  }
  const auto nAlongX = static_cast<std::size_t>(map.shape[0]);
  map.counts.resize(nRows * nAlongX);
  parallelFor(nRows, [&](std::size_t row) {
    Vec<Dim> x = map.lower + Vec<Dim>::filled(0.5 * map.spacing);
    std::size_t rest = row;
    for (int a = 1; a < Dim; ++a) {
      const auto n = static_cast<std::size_t>(map.shape[static_cast<std::size_t>(a)]);
      x[a] += static_cast<double>(rest % n) * map.spacing;
      rest /= n;
    }
    sampleRow(regions, frame.domain, map.spacing, map.step, x,
              std::span(map.counts).subspan(row * nAlongX, nAlongX));
  });
  return map;
}

template ContainerMap<1> containerMap(const std::vector<GeometryPtr<1>>&, const SceneFrame<1>&);
template ContainerMap<2> containerMap(const std::vector<GeometryPtr<2>>&, const SceneFrame<2>&);
template ContainerMap<3> containerMap(const std::vector<GeometryPtr<3>>&, const SceneFrame<3>&);

template std::vector<GeometryPtr<1>> containerRegions(const CaseNode&, const CaseSettings&,
                                                      const Regions<1>&,
                                                      const std::vector<FluidFill<1>>&,
                                                      const SceneFrame<1>&);
template std::vector<GeometryPtr<2>> containerRegions(const CaseNode&, const CaseSettings&,
                                                      const Regions<2>&,
                                                      const std::vector<FluidFill<2>>&,
                                                      const SceneFrame<2>&);
template std::vector<GeometryPtr<3>> containerRegions(const CaseNode&, const CaseSettings&,
                                                      const Regions<3>&,
                                                      const std::vector<FluidFill<3>>&,
                                                      const SceneFrame<3>&);

}  // namespace plenum
