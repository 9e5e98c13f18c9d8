// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/positions.hpp"

#include "geometry/text_reader.hpp"
#include "ictools/csv_points.hpp"
#include "ictools/point_grid.hpp"
#include "particles/gadget_reader.hpp"
#include "particles/vtu_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

/// Bytes of memory a byte of the file, at most: coordinates of short texts ("0 0\n") become 24
/// bytes each beside the text, compressed ones are decoded before they are converted.
constexpr double memoryPerByte = 12;

template <int Dim>
FilePoints readPoints(const std::filesystem::path& path, const CaseNode& file) {
  const std::string ending = extensionOf(path);
  if (ending == ".vtu") return readVtuPoints(readWholeFile(path, memoryPerByte), path.string());
  if (ending == ".csv")
    return readCsvPoints(readWholeFile(path, memoryPerByte), Dim, path.string());
  if (ending == ".hdf" || ending == ".hdf5") {
    openFile(path, memoryPerByte);  // says so if it is missing, empty or too large
    return readGadgetPoints(path);
  }
  file.fail(
      fmt::format("no positions are read from files ending in '{}'; export .vtu, .csv, .hdf5 "
                  "or .hdf",
                  ending));
}

/// In the case's dimension and place. Throws for what is not finite or no plane set.
template <int Dim>
std::vector<Vec<Dim>> placed(const std::vector<Vec<3>>& given, const PositionsKeys& keys,
                             double roundOff, const CaseNode& file) {
  std::vector<Vec<Dim>> points(given.size());
  for (std::size_t k = 0; k < given.size(); ++k) {
    for (int a = 0; a < 3; ++a) {
      if (!std::isfinite(given[k][a]))
        file.fail(fmt::format("point {} has {} = {}, must be finite; repair or remove it", k + 1,
                              "xyz"[a], given[k][a]));
      if (a >= Dim && keys.scale * std::abs(given[k][a] - given.front()[a]) > roundOff)
        file.fail(
            fmt::format("point {} has {} = {:g}, the first point {:g}; in {} dimension{} they must "
                        "be the same: export one plane, or set the case's dimension",
                        k + 1, "xyz"[a], given[k][a], given.front()[a], Dim, Dim == 1 ? "" : "s"));
      if (a < Dim)
        points[k][a] = keys.scale * given[k][a] +
                       (keys.translate.empty() ? 0 : keys.translate[static_cast<std::size_t>(a)]);
    }
  }
  return points;
}

/// How far each point lies outside of the region, or of the periodic domain [m]; negative inside.
template <int Dim>
std::vector<double> distancesOutside(const FluidFill<Dim>& fluid,
                                     const std::vector<Vec<Dim>>& points, const Box<Dim>& domain) {
  std::vector<double> outside(points.size(), -std::numeric_limits<double>::infinity());
  if (fluid.region) outside = signedDistances<Dim>(*fluid.region, points);
  for (std::size_t k = 0; k < points.size(); ++k)
    for (int a = 0; a < Dim; ++a)
      if (domain.isPeriodic(a))
        outside[k] =
            std::max({outside[k], domain.lower[a] - points[k][a], points[k][a] - domain.upper[a]});
  return outside;
}

template <int Dim>
std::string printed(const Vec<Dim>& x) {
  return fmt::format("({:g})", fmt::join(x.components, ", "));
}

/// Two particles at one place would never part: no force between them has a direction.
template <int Dim>
void checkApart(const FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame, const CaseNode& file) {
  const PointGrid<Dim> grid(fluid.box, surfaceRoundOff * frame.spacing, fluid.points);
  std::size_t nTwins = 0, first = 0;
  for (std::size_t k = 0; k < fluid.points.size(); ++k)
    if (std::isfinite(grid.nearest(fluid.points[k], k)) && nTwins++ == 0) first = k;
  if (nTwins > 0)
    file.fail(
        fmt::format("{} of {} points share their place with another, the first at {}, within {:g} "
                    "m; remove the doubles, or check the spacing",
                    nTwins, fluid.points.size(), printed(fluid.points[first]),
                    surfaceRoundOff * frame.spacing));
}

}  // namespace

template <int Dim>
void checkInside(const FluidFill<Dim>& fluid, const std::vector<Vec<Dim>>& points,
                 const SceneFrame<Dim>& frame, const CaseNode& file) {
  const std::vector<double> outside = distancesOutside(fluid, points, frame.domain);
  // The file's digits and the region's own tolerance decide on which side such a point lies.
  const double allowed =
      surfaceRoundOff * frame.spacing + (fluid.region ? fluid.region->tolerance() : 0);
  const auto nOutside = std::ranges::count_if(outside, [&](double d) { return d > allowed; });
  if (nOutside == 0) return;
  const auto worst = std::ranges::max_element(outside) - outside.begin();
  Box<Dim> bounds = Box<Dim>::nothing();
  for (const Vec<Dim>& x : points) bounds.extend(x);
  file.fail(fmt::format(
      "{} of {} points lie outside of the {} of fluid \"{}\", the furthest at {}, {:.3g} m away; "
      "the points reach from {} to {}, the fluid from {} to {}: set scale (0.001 for millimetres) "
      "or translate, or make the region larger",
      nOutside, points.size(), fluid.region ? "region" : "periodic domain", fluid.settings.name,
      printed(points[static_cast<std::size_t>(worst)]), outside[static_cast<std::size_t>(worst)],
      printed(bounds.lower), printed(bounds.upper), printed(fluid.box.lower),
      printed(fluid.box.upper)));
}

template <int Dim>
void placeFromFile(FluidFill<Dim>& fluid, const std::filesystem::path& folder,
                   const SceneFrame<Dim>& frame, const Warn& warn) {
  const PositionsKeys& keys = *fluid.settings.positions;
  const CaseNode& file = at(at(fluid.settings.node, "positions"), "file");
  const std::filesystem::path path = folder / keys.file;
  const FilePoints given = readPoints<Dim>(path, file);
  if (given.positions.empty())
    file.fail(given.nWalls == 0
                  ? "holds no points; export it again"
                  : fmt::format("holds no fluid: its {} particles are walls", given.nWalls));
  if (given.nWalls > 0)
    warn(fmt::format("fluid \"{}\": {} wall particles of {} are left out; {} remain",
                     fluid.settings.name, given.nWalls, path.string(), given.positions.size()));
  std::vector<Vec<Dim>> points =
      placed<Dim>(given.positions, keys, surfaceRoundOff * frame.spacing, file);
  checkInside(fluid, points, frame, file);
  for (Vec<Dim>& x : points) x = frame.domain.wrap(x);
  fluid.points = std::move(points);
  fluid.isPlaced = true;
  checkApart(fluid, frame, file);
}

template void checkInside(const FluidFill<1>&, const std::vector<Vec<1>>&, const SceneFrame<1>&,
                          const CaseNode&);
template void checkInside(const FluidFill<2>&, const std::vector<Vec<2>>&, const SceneFrame<2>&,
                          const CaseNode&);
template void checkInside(const FluidFill<3>&, const std::vector<Vec<3>>&, const SceneFrame<3>&,
                          const CaseNode&);
template void placeFromFile(FluidFill<1>&, const std::filesystem::path&, const SceneFrame<1>&,
                            const Warn&);
template void placeFromFile(FluidFill<2>&, const std::filesystem::path&, const SceneFrame<2>&,
                            const Warn&);
template void placeFromFile(FluidFill<3>&, const std::filesystem::path&, const SceneFrame<3>&,
                            const Warn&);

}  // namespace plenum
