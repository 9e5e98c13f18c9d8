// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/surroundings.hpp"

#include "ictools/layer_points.hpp"
#include "ictools/number_density.hpp"
#include "ictools/point_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

/// Removes the points that `isTaken(k)` names.
template <int Dim, class IsTaken>
void eraseTaken(std::vector<FixedPoint<Dim>>& points, IsTaken&& isTaken) {
  std::size_t k = 0;
  std::erase_if(points, [&](const FixedPoint<Dim>&) { return isTaken(k++); });
}

/// How a fluid goes on behind its free surface.
struct Shell {
  double reach;    ///< [m]
  double spacing;  ///< of its layers [m]
};

/// From the particles nearest to the surface: the finest of their spacings, the largest support.
/// The spacing is one for all of the surface, so where that takes many times the fluid's particles
/// it is coarser, and holds the finest of them less evenly.
template <int Dim>
Shell shellOf(const FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame, double lengthOverSpacing) {
  if (!fluid.spacingVaries())
    return {frame.support() * fluid.lengthScale, frame.spacing * fluid.lengthScale};
  const auto volumes = targetVolumes<Dim>(fluid, fluid.points, frame.domain);
  const auto distances = signedDistances<Dim>(*fluid.region, fluid.points);
  double least = std::numeric_limits<double>::infinity(), most = 0, area = 0;
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    const double edge = std::pow(volumes[k], 1.0 / Dim);
    if (-distances[k] > 2 * edge) continue;
    least = std::min(least, edge);
    most = std::max(most, edge);
    if (-distances[k] < edge) area += std::pow(edge, Dim - 1);
  }
  if (most == 0) return {frame.support(), frame.spacing};
  const double reach = 2 * lengthOverSpacing * most;
  const double affordable = 2 * static_cast<double>(fluid.points.size()) + 1e5;
  const double wanted = area * reach / std::pow(least, Dim);
  if (wanted > affordable) least *= std::pow(wanted / affordable, 1.0 / Dim);
  const double cellEdge = std::pow(fluid.lattice.cellVolume(), 1.0 / Dim);
  return {reach, frame.spacing * fluid.lengthScale * least / cellEdge};
}

/// The fluid continued past its surface, whatever is there. Lattices go on; for particles that will
/// stand as they please there are layers along the surface, which leave them just the room that
/// they need: the next lattice point may be up to a spacing away, and evens out over curved
/// surfaces only.
template <int Dim>
std::vector<FixedPoint<Dim>> continued(const FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame,
                                       const Shell& shell) {
  const Box<Dim> box = frame.clipped(fluid.box.grown(shell.reach));
  std::vector<FixedPoint<Dim>> points;
  if (fluid.settings.hasLattice() && !fluid.spacingVaries()) {
    const DistanceBand band{-surfaceRoundOff * frame.spacing, shell.reach};
    for (const Vec<Dim>& x : latticePoints(fluid.lattice, box, *fluid.region, band))
      points.push_back({x, fluid.lattice.cellVolume()});
    return points;
  }
  const int layers = static_cast<int>(std::ceil(shell.reach / shell.spacing - 1e-9));
  const WallSolid<Dim> outside{fluid.region, true};
  // Sampled in any dimension: tracing lays a grid over the whole box, and a shell may be fine.
  for (const Layer<Dim>& layer : sampleLayers(outside, shell.spacing, layers, box))
    for (const Vec<Dim>& x : layer.points)
      points.push_back({x, layer.volume / static_cast<double>(layer.points.size())});
  return points;
}

/// What of that lies neither in another fluid nor in a wall.
template <int Dim>
std::vector<FixedPoint<Dim>> freeShell(const std::vector<FluidFill<Dim>>& fluids, std::size_t own,
                                       const std::vector<WallFill<Dim>>& walls,
                                       const SceneFrame<Dim>& frame,
                                       const std::vector<Shell>& shells) {
  const double roundOff = surfaceRoundOff * frame.spacing;
  auto points = continued(fluids[own], frame, shells[own]);
  const auto positions = [&] {
    std::vector<Vec<Dim>> all;
    for (const auto& point : points) all.push_back(point.position);
    return all;
  };
  for (std::size_t k = 0; k < fluids.size(); ++k) {
    if (k == own || !fluids[k].region) continue;
    // What the shells of two fluids reach belongs to the finer one, else to the first.
    const bool yields = shells[k].spacing < shells[own].spacing ||
                        (shells[k].spacing == shells[own].spacing && k < own);
    const double within = yields ? shells[k].reach : roundOff;
    const auto distances = signedDistances<Dim>(*fluids[k].region, positions());
    eraseTaken(points, [&](std::size_t i) { return distances[i] <= within; });
  }
  for (const WallFill<Dim>& wall : walls) {
    const auto distances = signedDistances<Dim>(*wall.solid.geometry, positions());
    eraseTaken(points, [&](std::size_t i) {
      const double depth = wall.solid.depth(distances[i]);
      return depth >= -roundOff && depth <= wall.thickness + roundOff;
    });
  }
  return points;
}

}  // namespace

template <int Dim>
std::vector<FixedPoint<Dim>> surroundings(const std::vector<FluidFill<Dim>>& fluids,
                                          const std::vector<WallFill<Dim>>& walls,
                                          const SceneFrame<Dim>& frame, double lengthOverSpacing) {
  std::vector<FixedPoint<Dim>> fixed;
  Box<Dim> box = fluids.front().box;
  for (const auto& wall : walls)
    for (const WallPoint<Dim>& point : wall.points) {
      fixed.push_back({point.position, point.volume});
      box.extend(point.position);
    }
  const bool everywhere = std::ranges::any_of(fluids, [](const auto& f) { return !f.region; });
  if (everywhere) return fixed;
  PointGrid<Dim> taken(frame.clipped(box.grown(frame.spacing)), closestInWalls * frame.spacing,
                       fixed.size());
  for (const FixedPoint<Dim>& point : fixed) taken.insert(point.position);
  std::vector<Shell> shells;
  for (const auto& fluid : fluids) shells.push_back(shellOf(fluid, frame, lengthOverSpacing));
  for (std::size_t k = 0; k < fluids.size(); ++k) {
    const double apart = closestInWalls * std::min(frame.spacing, shells[k].spacing);
    for (const FixedPoint<Dim>& point : freeShell(fluids, k, walls, frame, shells))
      if (!(taken.nearest(point.position) < apart)) fixed.push_back(point);
  }
  return fixed;
}

template std::vector<FixedPoint<1>> surroundings(const std::vector<FluidFill<1>>&,
                                                 const std::vector<WallFill<1>>&,
                                                 const SceneFrame<1>&, double);
template std::vector<FixedPoint<2>> surroundings(const std::vector<FluidFill<2>>&,
                                                 const std::vector<WallFill<2>>&,
                                                 const SceneFrame<2>&, double);
template std::vector<FixedPoint<3>> surroundings(const std::vector<FluidFill<3>>&,
                                                 const std::vector<WallFill<3>>&,
                                                 const SceneFrame<3>&, double);

}  // namespace plenum
