// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/thin_parts.hpp"

#include "ictools/point_grid.hpp"
#include "particles/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace plenum {

namespace {

constexpr double emptyDistance = 2;  // d_ref
constexpr int stepsThrough = 8;

/// Surface points about every spacing, also of slits that no lattice point lies in.
template <int Dim>
std::vector<SurfacePoint<Dim>> surfacePoints(const FluidFill<Dim>& fluid,
                                             const SceneFrame<Dim>& frame) {
  const double d = frame.spacing;
  const Box<Dim> box = frame.clipped(fluid.region->bounds().grown(d));
  const auto near = latticePoints(fluid.lattice, box, *fluid.region, {-d, d});
  return closestPoints<Dim>(*fluid.region, near);
}

/// Places where the region is thinner than `widest` [m]; up to d_ref/8 more than it really is.
template <int Dim>
std::vector<ThinPlace<Dim>> thinPlaces(const FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame,
                                       double widest) {
  const double step = frame.spacing / stepsThrough;
  const Geometry<Dim>& region = *fluid.region;
  const auto feet = surfacePoints(fluid, frame);
  std::vector<Vec<Dim>> inward(feet.size());
  for (std::size_t k = 0; k < feet.size(); ++k)
    inward[k] = feet[k].point - widest / 2 * feet[k].normal;
  const auto depth = signedDistances<Dim>(region, inward);
  std::vector<ThinPlace<Dim>> places;
  for (std::size_t k = 0; k < feet.size(); ++k) {
    if (depth[k] < -0.499 * widest) continue;  // a ball of that diameter fits
    for (int n = 1; n * step < (1 - 1e-9) * widest; ++n) {
      const SurfacePoint<Dim> exit = region.closest(feet[k].point - n * step * feet[k].normal);
      if (exit.signedDistance < 0) continue;
      if (dot(exit.normal, feet[k].normal) < oppositeCosine)
        places.push_back({feet[k].point, feet[k].normal, n * step});
      break;
    }
  }
  return places;
}

/// Leaves out the places that a refinement gives more than one particle across.
template <int Dim>
void leaveOutRefined(std::vector<ThinPlace<Dim>>& places, const FluidFill<Dim>& fluid,
                     const SceneFrame<Dim>& frame) {
  if (!fluid.resolution) return;
  std::vector<Vec<Dim>> points;
  for (const auto& place : places) points.push_back(frame.domain.wrap(place.point));
  const auto ratios = ratiosAt<Dim>(*fluid.resolution, points);
  std::size_t k = 0;
  std::erase_if(places,
                [&](const auto& place) { return place.thickness >= ratios[k++] * frame.spacing; });
}

/// The way through the region at a place, by halving its last step [m].
template <int Dim>
double measured(const ThinPlace<Dim>& place, const Geometry<Dim>& region, double step) {
  double inside = place.thickness - step, outside = place.thickness;
  constexpr int halvings = 20;  // of d_ref/8: far below what messages show
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (inside + outside);
    const bool isIn = region.signedDistance(place.point - middle * place.normal) < 0;
    (isIn ? inside : outside) = middle;
  }
  return outside;
}

template <int Dim>
Finding emptyPart(const FluidFill<Dim>& fluid, const ThinPlace<Dim>& place, double spacing) {
  return {Severity::error,
          fmt::format("{}: the region is at most {:g} m thick at ({:g}), less than the spacing of "
                      "{:g} m, and no particle stands there",
                      at(fluid.settings.node, "region").where(), place.thickness,
                      fmt::join(place.point.components, ", "), spacing),
          fmt::format("a spacing of {:g} m or less is needed", place.thickness / 2),
          {place.point.components.begin(), place.point.components.end()}};
}

}  // namespace

template <int Dim>
std::optional<ThinPlace<Dim>> thinnestPlace(const FluidFill<Dim>& fluid,
                                            const SceneFrame<Dim>& frame, double widest) {
  if (!fluid.region) return std::nullopt;
  const auto places = thinPlaces(fluid, frame, widest);
  if (places.empty()) return std::nullopt;
  ThinPlace<Dim> thinnest = *std::ranges::min_element(places, {}, &ThinPlace<Dim>::thickness);
  thinnest.thickness = measured(thinnest, *fluid.region, frame.spacing / stepsThrough);
  return thinnest;
}

template <int Dim>
void checkThinParts(const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame,
                    const Warn& warn) {
  Box<Dim> box = Box<Dim>::nothing();
  for (const auto& fluid : fluids) box.extend(fluid.box);
  const double reach = emptyDistance * frame.spacing;
  std::vector<Vec<Dim>> points;  // and their grid: made for the first thin place
  std::optional<PointGrid<Dim>> grid;
  Findings findings;
  for (const auto& fluid : fluids) {
    if (!fluid.region) continue;
    auto places = thinPlaces(fluid, frame, frame.spacing);
    leaveOutRefined(places, fluid, frame);
    if (places.empty()) continue;
    if (!grid) {
      points = allPoints(fluids);
      grid.emplace(frame.clipped(box.grown(frame.spacing)), reach, points);
    }
    const auto isEmpty = [&](const ThinPlace<Dim>& place) {
      return !(grid->nearest(frame.domain.wrap(place.point)) <= reach);
    };
    const auto empty = std::ranges::find_if(places, isEmpty);
    if (empty != places.end()) {
      findings.add(emptyPart(fluid, *empty, frame.spacing));
      continue;
    }
    const auto thinnest = std::ranges::min_element(places, {}, &ThinPlace<Dim>::thickness);
    warn(
        fmt::format("fluid \"{}\": its region is thinner than the spacing of {:g} m in places, at "
                    "most {:g} m at "
                    "({:g}); fewer than two particles lie across",
                    fluid.settings.name, frame.spacing, thinnest->thickness,
                    fmt::join(thinnest->point.components, ", ")));
  }
  findings.throwErrors();
}

template void checkThinParts(const std::vector<FluidFill<1>>&, const SceneFrame<1>&, const Warn&);
template void checkThinParts(const std::vector<FluidFill<2>>&, const SceneFrame<2>&, const Warn&);
template void checkThinParts(const std::vector<FluidFill<3>>&, const SceneFrame<3>&, const Warn&);

template std::optional<ThinPlace<1>> thinnestPlace(const FluidFill<1>&, const SceneFrame<1>&,
                                                   double);
template std::optional<ThinPlace<2>> thinnestPlace(const FluidFill<2>&, const SceneFrame<2>&,
                                                   double);
template std::optional<ThinPlace<3>> thinnestPlace(const FluidFill<3>&, const SceneFrame<3>&,
                                                   double);

}  // namespace plenum
