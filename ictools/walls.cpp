// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/walls.hpp"

#include "ictools/layer_points.hpp"
#include "ictools/point_grid.hpp"
#include "ictools/wall_motions.hpp"
#include "ictools/wall_resolution.hpp"
#include "particles/findings.hpp"
#include "particles/memory.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// A wall all of whose spacing is finer than this part of what would do somewhere gets a warning.
constexpr double unevenWall = 0.6;

/// Grows `box` by the finite ones of `bounds`' faces.
template <int Dim>
void extendFinite(Box<Dim>& box, const Box<Dim>& bounds) {
  for (int a = 0; a < Dim; ++a)
    for (const double face : {bounds.lower[a], bounds.upper[a]}) {
      if (!std::isfinite(face)) continue;
      box.lower[a] = std::min(box.lower[a], face);
      box.upper[a] = std::max(box.upper[a], face);
    }
}

/// Removes places that an earlier wall has, or that are too near to one of its particles.
template <int Dim>
void leaveToEarlier(std::vector<WallFill<Dim>>& walls, std::size_t w, const PointGrid<Dim>& taken,
                    const SceneFrame<Dim>& frame) {
  auto& points = walls[w].points;
  const double roundOff = surfaceRoundOff * frame.spacing;
  for (std::size_t earlier = 0; earlier < w; ++earlier) {
    std::vector<Vec<Dim>> positions;
    for (const auto& point : points) positions.push_back(point.position);
    const WallSolid<Dim>& solid = walls[earlier].solid;
    const auto distances = signedDistances<Dim>(*solid.geometry, positions);
    std::size_t k = 0;
    std::erase_if(points, [&](const WallPoint<Dim>&) {
      const double depth = solid.depth(distances[k++]);
      return depth >= -roundOff && depth <= walls[earlier].thickness + roundOff;
    });
  }
  std::erase_if(points, [&](const WallPoint<Dim>& point) {
    return taken.nearest(point.position) < closestInWalls * walls[w].spacing * (1 - 1e-9);
  });
}

/// Two geometries that are meshed apart agree on their common surface to a tolerance only: a
/// lattice point between them would be a fluid and a wall particle. The fluid has it.
template <int Dim>
void leaveToFluid(WallFill<Dim>& wall, const PointGrid<Dim>& fluid, double spacing) {
  std::erase_if(wall.points, [&](const WallPoint<Dim>& point) {
    return fluid.nearest(point.position) < 0.1 * spacing;
  });
}

/// Layers in two dimensions are traced on a grid over all of the box: a wall much finer than the
/// rest may want more of it than there is memory for.
template <int Dim>
void checkTracing(const WallFill<Dim>& wall, const Box<Dim>& box) {
  if (Dim != 2 || wall.settings.method != "conformal") return;
  const double needed = bytesOfTracing(wall.spacing, box.volume());
  const double available = availableMemory().value_or(needed);
  if (needed <= available) return;
  at(wall.settings.node, "method")
      .fail(
          fmt::format("conformal layers {:g} m apart in a scene of {:g} m^2 need {} of memory, {} "
                      "are available; set method = \"lattice\", or a larger spacing of the "
                      "case or of [[refine]]",
                      wall.spacing, box.volume(), printedBytes(needed), printedBytes(available)));
}

template <int Dim>
const FluidFill<Dim>& fluidNamed(const std::vector<FluidFill<Dim>>& fluids,
                                 const WallSettings& wall) {
  if (wall.latticeOf.empty()) return fluids.front();
  std::vector<std::string> names;
  for (const auto& fluid : fluids) {
    if (fluid.settings.name == wall.latticeOf) return fluid;
    names.push_back(fluid.settings.name);
  }
  at(wall.node, "lattice_of").fail(fmt::format("no such fluid; known: {}", fmt::join(names, ", ")));
}

}  // namespace

template <int Dim>
Box<Dim> wallBox(const std::vector<WallFill<Dim>>& walls, const std::vector<FluidFill<Dim>>& fluids,
                 const Box<Dim>& container, const SceneFrame<Dim>& frame) {
  Box<Dim> box = Box<Dim>::nothing();
  extendFinite(box, container);
  for (const auto& fluid : fluids) extendFinite(box, fluid.box);
  double thickest = 0;
  for (const auto& wall : walls) {
    extendFinite(box, wall.solid.geometry->bounds());
    thickest = std::max(thickest, wall.thickness);
  }
  return frame.clipped(box.grown(thickest + surfaceRoundOff * frame.spacing));
}

int layersNeeded(double support, double spacing) {
  return static_cast<int>(std::ceil(support / spacing - 1e-9));
}

template <int Dim>
WallFill<Dim> prepareWall(const WallSettings& settings, GeometryPtr<Dim> geometry,
                          const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame,
                          const std::filesystem::path& folder, const Warn& warn) {
  const FluidFill<Dim>& fluid = fluidNamed(fluids, settings);
  WallFill<Dim> wall{settings,
                     {std::move(geometry), !settings.outside.empty()},
                     fluid.lattice,
                     frame.spacing,
                     frame.support()};
  const WallResolution along = resolutionAlong(wall.solid, fluids, frame);
  if (along.finest < 1) {
    wall.spacing *= along.finest;
    wall.lattice = latticeWith(fluid, wall.spacing * fluid.lengthScale, frame);
  }
  wall.support = along.support;
  if (along.finest < unevenWall * along.coarsest)
    warn(
        fmt::format("wall \"{}\" has a spacing of {:g} m everywhere, the finest of the fluid along "
                    "it, though {:g} m would do in places; make it several walls to save particles",
                    settings.name, wall.spacing, along.coarsest * frame.spacing));
  const int needed = layersNeeded(wall.support, wall.spacing);
  wall.layers = settings.layers.value_or(needed);
  wall.density = settings.density.value_or(fluid.settings.density);
  wall.thickness = wall.layers * wall.spacing;
  wall.motion = rigidMotion<Dim>(settings, folder);
  if (wall.layers < needed)
    warn(
        fmt::format("wall \"{}\" has {} layers of {:g} m, the kernel's support of {:g} m needs {}: "
                    "plenum-sph will refuse this set; leave out `layers` or set it to {}",
                    settings.name, wall.layers, wall.spacing, wall.support, needed, needed));
  return wall;
}

template <int Dim>
void checkFluidOutsideWalls(const std::vector<FluidFill<Dim>>& fluids,
                            const std::vector<WallFill<Dim>>& walls, const SceneFrame<Dim>& frame) {
  Findings findings;
  for (const auto& wall : walls)
    for (const auto& fluid : fluids) {
      const double tolerance =
          wall.solid.geometry->tolerance() + (fluid.region ? fluid.region->tolerance() : 0);
      const double allowed = tolerance - surfaceRoundOff * frame.spacing;
      const auto places = placesOf<Dim>(*wall.solid.geometry, fluid.points,
                                        fluid.lattice.edges()[0], std::abs(allowed));
      const PointPlace clear = wall.solid.isOutside ? PointPlace::inside : PointPlace::outside;
      std::size_t nInside = 0, deepest = 0;
      double most = 0;
      for (std::size_t k = 0; k < places.size(); ++k) {
        if (places[k] == clear) continue;
        const double depth = wall.solid.depth(wall.solid.geometry->signedDistance(fluid.points[k]));
        if (depth < allowed) continue;
        if (nInside++ > 0 && depth <= most) continue;
        deepest = k;
        most = depth;
      }
      if (nInside == 0) continue;
      const Vec<Dim>& place = fluid.points[deepest];
      findings.add(
          {Severity::error,
           fmt::format("{}: {} of {} particles of fluid \"{}\" stand in the solid of wall \"{}\", "
                       "the deepest at ({:g}), {:g} m behind its surface",
                       at(wall.settings.node, wall.settings.regionKey()).where(), nInside,
                       fluid.points.size(), fluid.settings.name, wall.settings.name,
                       fmt::join(place.components, ", "), most),
           fmt::format("take the solid out of the fluid's region, e.g. {{ {} = [\"{}\", \"{}\"] }}",
                       wall.solid.isOutside ? "intersection" : "difference",
                       fluid.settings.region.empty() ? "everything" : fluid.settings.region,
                       wall.solid.isOutside ? wall.settings.outside : wall.settings.region),
           {place.components.begin(), place.components.end()}});
    }
  findings.throwErrors();
}

template <int Dim>
void fillWalls(std::vector<WallFill<Dim>>& walls, const std::vector<FluidFill<Dim>>& fluids,
               const Box<Dim>& container, const SceneFrame<Dim>& frame) {
  if (walls.empty()) return;
  const Box<Dim> box = wallBox(walls, fluids, container, frame);
  const std::vector<Vec<Dim>> fluidPoints = allPoints(fluids);
  double finest = frame.spacing;  // cells as small as refined fluid, but larger than what is asked
  for (const auto& wall : walls) finest = std::min(finest, wall.spacing);
  const PointGrid<Dim> fluid(box, std::max(finest, 0.1 * frame.spacing), fluidPoints);
  PointGrid<Dim> taken(box, closestInWalls * frame.spacing, fluidPoints.size());
  for (std::size_t w = 0; w < walls.size(); ++w) {
    WallFill<Dim>& wall = walls[w];
    checkTracing(wall, box);
    wall.points = wall.settings.method == "lattice"
                      ? latticeLayers(wall.solid, wall.lattice, wall.spacing, wall.thickness, box)
                      : conformalLayers(wall.solid, wall.spacing, wall.layers, box);
    leaveToEarlier(walls, w, taken, frame);
    leaveToFluid(wall, fluid, wall.spacing);
    if (wall.points.empty())
      at(wall.settings.node, wall.settings.regionKey())
          .fail(fmt::format("wall \"{}\" gets no particle: its solid ({}) is thinner than the "
                            "spacing, lies inside of earlier walls or beyond the domain",
                            wall.settings.name, wall.solid.geometry->describe()));
    for (const auto& point : wall.points) taken.insert(point.position);
  }
}

template Box<1> wallBox(const std::vector<WallFill<1>>&, const std::vector<FluidFill<1>>&,
                        const Box<1>&, const SceneFrame<1>&);
template WallFill<1> prepareWall(const WallSettings&, GeometryPtr<1>,
                                 const std::vector<FluidFill<1>>&, const SceneFrame<1>&,
                                 const std::filesystem::path&, const Warn&);
template void checkFluidOutsideWalls(const std::vector<FluidFill<1>>&,
                                     const std::vector<WallFill<1>>&, const SceneFrame<1>&);
template void fillWalls(std::vector<WallFill<1>>&, const std::vector<FluidFill<1>>&, const Box<1>&,
                        const SceneFrame<1>&);
template Box<2> wallBox(const std::vector<WallFill<2>>&, const std::vector<FluidFill<2>>&,
                        const Box<2>&, const SceneFrame<2>&);
template WallFill<2> prepareWall(const WallSettings&, GeometryPtr<2>,
                                 const std::vector<FluidFill<2>>&, const SceneFrame<2>&,
                                 const std::filesystem::path&, const Warn&);
template void checkFluidOutsideWalls(const std::vector<FluidFill<2>>&,
                                     const std::vector<WallFill<2>>&, const SceneFrame<2>&);
template void fillWalls(std::vector<WallFill<2>>&, const std::vector<FluidFill<2>>&, const Box<2>&,
                        const SceneFrame<2>&);
template Box<3> wallBox(const std::vector<WallFill<3>>&, const std::vector<FluidFill<3>>&,
                        const Box<3>&, const SceneFrame<3>&);
template WallFill<3> prepareWall(const WallSettings&, GeometryPtr<3>,
                                 const std::vector<FluidFill<3>>&, const SceneFrame<3>&,
                                 const std::filesystem::path&, const Warn&);
template void checkFluidOutsideWalls(const std::vector<FluidFill<3>>&,
                                     const std::vector<WallFill<3>>&, const SceneFrame<3>&);
template void fillWalls(std::vector<WallFill<3>>&, const std::vector<FluidFill<3>>&, const Box<3>&,
                        const SceneFrame<3>&);

}  // namespace plenum
