// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/thin_parts.hpp"

#include "ictools/point_grid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

namespace plenum {

namespace {

constexpr double emptyDistance = 2;  // d_ref
constexpr int stepsThrough = 8;

template <int Dim>
struct ThinPlace {
  Vec<Dim> point;
  double thickness;
};

/// Surface points about every spacing, also of slits that no lattice point lies in.
template <int Dim>
std::vector<SurfacePoint<Dim>> surfacePoints(const FluidFill<Dim>& fluid,
                                             const SceneFrame<Dim>& frame) {
  const double d = frame.spacing;
  const Box<Dim> box = frame.clipped(fluid.region->bounds().grown(d));
  const auto near = latticePoints(fluid.lattice, box, *fluid.region, {-d, d});
  return closestPoints<Dim>(*fluid.region, near);
}

template <int Dim>
std::vector<ThinPlace<Dim>> thinPlaces(const FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame) {
  const double d = frame.spacing;
  const Geometry<Dim>& region = *fluid.region;
  const auto feet = surfacePoints(fluid, frame);
  std::vector<Vec<Dim>> inward(feet.size());
  for (std::size_t k = 0; k < feet.size(); ++k) inward[k] = feet[k].point - d / 2 * feet[k].normal;
  const auto depth = signedDistances<Dim>(region, inward);
  std::vector<ThinPlace<Dim>> places;
  for (std::size_t k = 0; k < feet.size(); ++k) {
    if (depth[k] < -0.499 * d) continue;  // a ball of diameter d_ref fits
    for (int step = 1; step < stepsThrough; ++step) {
      const double thickness = d * step / stepsThrough;
      const SurfacePoint<Dim> exit = region.closest(feet[k].point - thickness * feet[k].normal);
      if (exit.signedDistance < 0) continue;
      if (dot(exit.normal, feet[k].normal) < oppositeCosine)
        places.push_back({feet[k].point, thickness});
      break;
    }
  }
  return places;
}

}  // namespace

template <int Dim>
void checkThinParts(const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame,
                    const Warn& warn) {
  Box<Dim> box = Box<Dim>::nothing();
  for (const auto& fluid : fluids) box.extend(fluid.box);
  const double reach = emptyDistance * frame.spacing;
  std::vector<Vec<Dim>> points;  // and their grid: made for the first thin place
  std::optional<PointGrid<Dim>> grid;
  for (const auto& fluid : fluids) {
    if (!fluid.region) continue;
    const auto places = thinPlaces(fluid, frame);
    if (places.empty()) continue;
    if (!grid) {
      points = allPoints(fluids);
      grid.emplace(frame.clipped(box.grown(frame.spacing)), reach, points);
    }
    const ThinPlace<Dim>* thinnest = &places.front();
    for (const auto& place : places) {
      if (place.thickness < thinnest->thickness) thinnest = &place;
      if (!(grid->nearest(frame.domain.wrap(place.point)) <= reach))
        at(fluid.settings.node, "region")
            .fail(fmt::format(
                "the region is at most {:g} m thick at ({:g}), less than the spacing of "
                "{:g} m, and no particle stands there; a spacing of {:g} m or less is "
                "needed",
                place.thickness, fmt::join(place.point.components, ", "), frame.spacing,
                place.thickness / 2));
    }
    warn(
        fmt::format("fluid \"{}\": its region is thinner than the spacing of {:g} m in places, at "
                    "most {:g} m at ({:g}); fewer than two particles lie across",
                    fluid.settings.name, frame.spacing, thinnest->thickness,
                    fmt::join(thinnest->point.components, ", ")));
  }
}

template void checkThinParts(const std::vector<FluidFill<1>>&, const SceneFrame<1>&, const Warn&);
template void checkThinParts(const std::vector<FluidFill<2>>&, const SceneFrame<2>&, const Warn&);
template void checkThinParts(const std::vector<FluidFill<3>>&, const SceneFrame<3>&, const Warn&);

}  // namespace plenum
