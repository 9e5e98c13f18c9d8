// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/wall_resolution.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// How far before a surface fluid is looked for, and the spacing of places there, in d_ref.
constexpr double before = 1.5, apart = 0.5;

/// Points of the surface that have fluid before them.
template <int Dim>
std::vector<Vec<Dim>> wettedPoints(const WallSolid<Dim>& solid,
                                   const std::vector<FluidFill<Dim>>& fluids,
                                   const SceneFrame<Dim>& frame) {
  std::vector<Vec<Dim>> wetted;
  for (const auto& fluid : fluids) {
    const Lattice<Dim> lattice = latticeWith(fluid, apart * frame.spacing, frame);
    auto points = latticePoints(lattice, frame.clipped(fluid.box), *solid.geometry,
                                solid.band(-before * frame.spacing, 0));
    if (fluid.region) {
      const auto distances = signedDistances<Dim>(*fluid.region, points);
      std::size_t k = 0;
      std::erase_if(points, [&](const Vec<Dim>&) { return distances[k++] > 0; });
    }
    for (const SurfacePoint<Dim>& foot : closestPoints<Dim>(*solid.geometry, points))
      wetted.push_back(frame.domain.wrap(foot.point));
  }
  return wetted;
}

/// Largest of 2h(x) - x at the distances x before the surface, where h grows with x.
template <int Dim>
double supportAt(double ratio, const Resolution<Dim>& resolution, const SceneFrame<Dim>& frame) {
  const double perSpacing = 2 * frame.solver.smoothingLength;
  const double near = perSpacing * ratio * frame.spacing;
  const double plainFrom = (1 - ratio) * frame.spacing / resolution.steepest();
  return std::max(near, frame.support() - plainFrom);
}

}  // namespace

template <int Dim>
WallResolution resolutionAlong(const WallSolid<Dim>& solid,
                               const std::vector<FluidFill<Dim>>& fluids,
                               const SceneFrame<Dim>& frame) {
  WallResolution along;
  along.support = frame.support();
  const ResolutionPtr<Dim> resolution = fluids.front().resolution;
  if (!resolution) return along;
  const auto ratios = ratiosAt<Dim>(*resolution, wettedPoints(solid, fluids, frame));
  if (ratios.empty()) return along;
  const auto [finest, coarsest] = std::ranges::minmax(ratios);
  along.finest = finest;
  along.coarsest = coarsest;
  along.support = supportAt(coarsest, *resolution, frame);
  return along;
}

template WallResolution resolutionAlong(const WallSolid<1>&, const std::vector<FluidFill<1>>&,
                                        const SceneFrame<1>&);
template WallResolution resolutionAlong(const WallSolid<2>&, const std::vector<FluidFill<2>>&,
                                        const SceneFrame<2>&);
template WallResolution resolutionAlong(const WallSolid<3>&, const std::vector<FluidFill<3>>&,
                                        const SceneFrame<3>&);

}  // namespace plenum
