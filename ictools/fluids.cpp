// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/fluids.hpp"

#include "ictools/equal_masses.hpp"
#include "ictools/number_density.hpp"
#include "ictools/point_grid.hpp"
#include "ictools/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace plenum {

namespace {

constexpr double maxParticles = 2147483648.0;  // 2^31: particles are numbered with 32 bits

const char* axisName(int axis) {
  static constexpr const char* names[] = {"x", "y", "z"};
  return names[axis];
}

template <int Dim>
void checkBounds(FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame, const Warn& warn) {
  const CaseNode& node = at(fluid.settings.node, "region");
  if (!fluid.region) {
    for (int a = 0; a < Dim; ++a)
      if (!frame.domain.isPeriodic(a))
        node.fail(
            fmt::format("fluid \"{}\" has no region and axis {} is not periodic; name a region "
                        "or list the axis in domain.periodic",
                        fluid.settings.name, axisName(a)));
    return;
  }
  const Box<Dim> bounds = fluid.region->bounds();
  for (int a = 0; a < Dim; ++a) {
    if (!frame.domain.isPeriodic(a)) {
      if (!std::isfinite(bounds.lower[a]) || !std::isfinite(bounds.upper[a]))
        node.fail(
            fmt::format("the region is infinite along {}; intersect it with a box", axisName(a)));
      if (!(bounds.lower[a] < bounds.upper[a]))
        node.fail("the region is empty: " + fluid.region->describe());
      continue;
    }
    const double beyond =
        std::max(frame.domain.lower[a] - bounds.lower[a], bounds.upper[a] - frame.domain.upper[a]);
    if (!(beyond > surfaceRoundOff * frame.spacing)) continue;
    fluid.isCut = true;
    const char* exactKey = fluid.settings.mass == "exact"       ? "mass"
                           : fluid.settings.lattice == "random" ? "lattice"
                                                                : nullptr;
    if (exactKey != nullptr)
      at(fluid.settings.node, exactKey)
          .fail(
              fmt::format("the region reaches beyond the periodic faces along {}, so its volume is "
                          "not the fluid's; end it there, or use a lattice and mass = \"cell\"",
                          axisName(a)));
    // A gas lies in its domain or there is a mistake: a cloud wider than its tunnel.
    if (std::isfinite(beyond) && frame.solver.equationOfState != "tait")
      node.fail(fmt::format(
          "the region of fluid \"{}\" is {:g} m long along {} and reaches {:g} m beyond the "
          "periodic domain of {:g} m; make the region smaller or the domain larger",
          fluid.settings.name, bounds.upper[a] - bounds.lower[a], axisName(a), beyond,
          frame.domain.upper[a] - frame.domain.lower[a]));
    if (std::isfinite(beyond))
      warn(
          fmt::format("fluid \"{}\": its region reaches {:g} m beyond the periodic faces along {}; "
                      "that part is cut off",
                      fluid.settings.name, beyond, axisName(a)));
  }
}

/// Too many particles are found out before memory is asked for.
template <int Dim>
void checkCount(const FluidFill<Dim>& fluid) {
  const double volume = std::min(fluid.volume.value, fluid.box.volume());
  if (!(volume > 0))
    at(fluid.settings.node, "region")
        .fail("the region is empty: " +
              (fluid.region ? fluid.region->describe() : std::string("domain")));
  const double expected = volume / fluid.lattice.cellVolume();
  if (expected < maxParticles) return;
  at(fluid.settings.node, "region")
      .fail(fmt::format(
          "would hold {:.3g} particles, more than 2^31; a spacing of at least {:.3g} m "
          "is needed (are the lengths in metres?)",
          expected, fluid.lattice.edges()[0] * std::pow(expected / maxParticles, 1.0 / Dim)));
}

/// The random numbers of fluid `k`: its seed's own for the first fluid, others for each further
/// one, so that fluids of one seed have nothing in common.
template <int Dim>
Random randomOf(const FluidFill<Dim>& fluid, std::size_t k) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio: far apart
  return Random(static_cast<std::uint64_t>(fluid.settings.seed) + golden * k);
}

/// Uniform points strictly inside the region, seeded.
template <int Dim>
std::vector<Vec<Dim>> randomPoints(const FluidFill<Dim>& fluid, double roundOff, Random random) {
  const double wanted = std::round(fluid.volume.value / fluid.lattice.cellVolume());
  const auto n = static_cast<std::size_t>(wanted);
  std::vector<Vec<Dim>> points;
  std::vector<Vec<Dim>> trial;
  constexpr int maxRounds = 10000;  // a region that is one part in ten thousand of its bounds
  for (int round = 0; points.size() < n; ++round) {
    if (round == maxRounds)
      at(fluid.settings.node, "region")
          .fail(fmt::format("only {} of {} random points were found to lie inside: {}",
                            points.size(), n, fluid.region->describe()));
    trial.clear();
    for (std::size_t k = points.size(); k < n; ++k) trial.push_back(random.pointIn(fluid.box));
    std::vector<double> distance(trial.size(), -1);
    if (fluid.region) distance = signedDistances<Dim>(*fluid.region, trial);
    for (std::size_t k = 0; k < trial.size(); ++k)
      if (distance[k] < -roundOff || !fluid.region) points.push_back(trial[k]);
  }
  return points;
}

/// True if every place around x lies in some fluid: one place in each orthant, so that one of them
/// is beyond any wall through x, and along no direction in which surfaces like to run.
template <int Dim>
bool isSurrounded(const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame,
                  const Vec<Dim>& x) {
  constexpr double skew[] = {1, 0.731, 0.533};
  const double step = 1e-3 * frame.spacing;
  for (int orthant = 0; orthant < (1 << Dim); ++orthant) {
    Vec<Dim> y = x;
    for (int a = 0; a < Dim; ++a) y[a] += ((orthant >> a) & 1 ? step : -step) * skew[a];
    y = frame.domain.wrap(y);
    if (std::none_of(fluids.begin(), fluids.end(),
                     [&](const auto& fluid) { return fluid.region->isInside(y); }))
      return false;
  }
  return true;
}

/// Lattice points on the surface that have fluid all around and that no earlier fluid has.
template <int Dim>
std::vector<Vec<Dim>> seamPoints(const std::vector<FluidFill<Dim>>& fluids, std::size_t k,
                                 const SceneFrame<Dim>& frame) {
  if (fluids.size() == 1 && !frame.domain.anyPeriodic()) return {};
  for (const auto& fluid : fluids)
    if (!fluid.region) return {};  // it has the whole domain
  const double roundOff = surfaceRoundOff * frame.spacing;
  auto points =
      latticePoints(fluids[k].lattice, fluids[k].box, *fluids[k].region, {-roundOff, roundOff});
  std::erase_if(points, [&](const Vec<Dim>& x) {
    for (std::size_t earlier = 0; earlier < k; ++earlier)
      if (fluids[earlier].region->signedDistance(x) <= roundOff) return true;
    return !isSurrounded(fluids, frame, x);
  });
  return points;
}

/// How many lattice points of a fluid lie inside of earlier ones: whether its region is its own,
/// when its points were given and none of them lies there.
template <int Dim>
std::size_t latticePlacesOfEarlier(const std::vector<FluidFill<Dim>>& fluids, std::size_t k,
                                   const SceneFrame<Dim>& frame) {
  const FluidFill<Dim>& fluid = fluids[k];
  if (k == 0) return 0;
  const double roundOff = surfaceRoundOff * frame.spacing;
  const auto points =
      fluid.region ? latticePoints(fluid.lattice, fluid.box, *fluid.region, {.upper = -roundOff})
                   : latticePoints(fluid.lattice, fluid.box);
  std::size_t n = 0;
  for (std::size_t earlier = 0; earlier < k; ++earlier) {
    if (!fluids[earlier].region) return points.size();
    const auto places =
        placesOf<Dim>(*fluids[earlier].region, points, fluid.lattice.edges()[0], roundOff);
    n += static_cast<std::size_t>(std::ranges::count(places, PointPlace::inside));
  }
  return n;
}

/// Removes the points inside earlier fluids, and those on their surface where they have a particle.
template <int Dim>
void leaveToEarlier(std::vector<FluidFill<Dim>>& fluids, std::size_t k,
                    const SceneFrame<Dim>& frame) {
  FluidFill<Dim>& fluid = fluids[k];
  const double roundOff = surfaceRoundOff * frame.spacing;
  const std::size_t before = fluid.points.size();
  for (std::size_t earlier = 0; earlier < k; ++earlier) {
    if (!fluids[earlier].region) {
      fluid.points.clear();
      break;
    }
    const Geometry<Dim>& region = *fluids[earlier].region;
    const auto places = placesOf<Dim>(region, fluid.points, fluid.lattice.edges()[0], roundOff);
    std::optional<PointGrid<Dim>> taken;  // made for the first point on the surface
    const auto isTaken = [&](const Vec<Dim>& x) {
      if (!taken) taken.emplace(fluids[earlier].box, frame.spacing / 2, fluids[earlier].points);
      return std::isfinite(taken->nearest(x));
    };
    std::size_t n = 0;
    std::erase_if(fluid.points, [&](const Vec<Dim>& x) {
      const PointPlace place = places[n++];
      if (place != PointPlace::unknown) return place == PointPlace::inside;
      const double here = region.signedDistance(x);
      return here < -roundOff || (here <= roundOff && isTaken(x));
    });
  }
  fluid.nCovered = before - fluid.points.size();
  if (fluid.isPlaced && fluid.nCovered == 0)
    fluid.nCovered = latticePlacesOfEarlier(fluids, k, frame);
  if (fluid.nCovered > 0 && fluid.settings.mass == "exact")
    at(fluid.settings.node, "mass")
        .fail(
            fmt::format("fluid \"{}\" overlaps an earlier one, so the volume of its region is not "
                        "its own; make its region a difference or use mass = \"cell\"",
                        fluid.settings.name));
}

/// Adds noise; a point that it would carry through the surface or into an earlier fluid stays.
template <int Dim>
void jitter(std::vector<FluidFill<Dim>>& fluids, std::size_t index, const SceneFrame<Dim>& frame) {
  FluidFill<Dim>& fluid = fluids[index];
  if (fluid.settings.jitter == 0) return;
  const double amplitude = fluid.settings.jitter * frame.spacing;
  Random random = randomOf(fluid, index);
  const Box<Dim> cube{Vec<Dim>::filled(-amplitude), Vec<Dim>::filled(amplitude), {}};
  std::vector<Vec<Dim>> moved = fluid.points;
  for (Vec<Dim>& x : moved) x = frame.domain.wrap(x + random.pointIn(cube));
  std::vector<double> distance(moved.size(), -1);
  if (fluid.region) distance = signedDistances<Dim>(*fluid.region, moved);
  for (std::size_t earlier = 0; earlier < index; ++earlier) {
    const auto beside = signedDistances<Dim>(*fluids[earlier].region, moved);
    for (std::size_t k = 0; k < moved.size(); ++k) distance[k] = std::max(distance[k], -beside[k]);
  }
  for (std::size_t k = 0; k < moved.size(); ++k)
    if (distance[k] < 0) fluid.points[k] = moved[k];
}

template <int Dim>
void checkNotEmpty(const FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame) {
  if (!fluid.points.empty()) return;
  const CaseNode& node = at(fluid.settings.node, "region");
  if (fluid.nCovered > 0)
    node.fail("gets no particle: earlier fluids cover all of it; change their order or regions");
  const Vec<Dim> extent = fluid.box.extent();
  double smallest = extent[0];
  for (int a = 1; a < Dim; ++a) smallest = std::min(smallest, extent[a]);
  node.fail(
      fmt::format("gets no particle: its bounds are {:g} m in the shortest direction, the "
                  "spacing is {:g} m; a smaller spacing is needed",
                  smallest, frame.spacing));
}

}  // namespace

template <int Dim>
void FluidFill<Dim>::placeLattice() {
  if (settings.latticeOrigin.empty()) return lattice.startAt(box.lower);
  Vec<Dim> origin;
  for (int a = 0; a < Dim; ++a) origin[a] = settings.latticeOrigin[static_cast<std::size_t>(a)];
  lattice.placeAt(origin);
}

template <int Dim>
Lattice<Dim> latticeWith(const FluidFill<Dim>& fluid, double spacing,
                         const SceneFrame<Dim>& frame) {
  const std::string& name =
      fluid.settings.lattice == "random" ? latticeNames(Dim).front() : fluid.settings.lattice;
  FluidFill<Dim> other{fluid.settings, {}, fluid.box, Lattice<Dim>(name, spacing)};
  other.lattice.fitTo(frame.domain);
  other.placeLattice();
  return other.lattice;
}

template <int Dim>
FluidFill<Dim> prepareFluid(const FluidSettings& settings, GeometryPtr<Dim> region,
                            DensityProfilePtr<Dim> profile, const SceneFrame<Dim>& frame,
                            const Warn& warn) {
  const std::string& lattice =
      settings.lattice == "random" ? latticeNames(Dim).front() : settings.lattice;
  FluidFill<Dim> fluid{settings, std::move(region), {}, Lattice<Dim>(lattice, frame.spacing)};
  fluid.profile = std::move(profile);
  checkBounds(fluid, frame, warn);
  fluid.box = fluid.region ? frame.clipped(fluid.region->bounds()) : frame.domain;
  fluid.volume = fluid.region ? fluid.region->volume() : Measure{frame.domain.volume(), 0};
  checkCount(fluid);
  if (settings.hasLattice()) fluid.lattice.fitTo(frame.domain);
  fluid.placeLattice();
  return fluid;
}

template <int Dim>
void fillFluids(std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame) {
  const double roundOff = surfaceRoundOff * frame.spacing;
  for (std::size_t k = 0; k < fluids.size(); ++k) {
    FluidFill<Dim>& fluid = fluids[k];
    if (fluid.isPlaced) {
      // keeps its points
    } else if (fluid.spacingVaries()) {
      fillByNumberDensity(fluid, frame, randomOf(fluid, k));
    } else if (fluid.settings.lattice == "random") {
      fluid.points = randomPoints(fluid, roundOff, randomOf(fluid, k));
    } else if (!fluid.region) {
      fluid.points = latticePoints(fluid.lattice, fluid.box);
    } else {
      fluid.points = latticePoints(fluid.lattice, fluid.box, *fluid.region, {.upper = -roundOff});
      const std::vector<Vec<Dim>> seam = seamPoints(fluids, k, frame);
      if (!seam.empty()) fluid.points.reserve(fluid.points.size() + seam.size());  // no more
      fluid.points.insert(fluid.points.end(), seam.begin(), seam.end());
    }
    leaveToEarlier(fluids, k, frame);
    checkNotEmpty(fluid, frame);
    jitter(fluids, k, frame);
    if (fluid.settings.spacingFollowsDensity())
      fluid.particleVolume = fluid.meanVolume();
    else if (fluid.resolution)
      fluid.particleVolume = fluid.lattice.cellVolume();  // exact ones wait for the last places
    else
      fluid.particleVolume = fluid.settings.mass == "exact"
                                 ? fluid.volume.value / static_cast<double>(fluid.points.size())
                                 : fluid.lattice.cellVolume();
  }
  for (auto& fluid : fluids) {
    if (fluid.settings.equalMassWith.empty()) continue;
    const FluidFill<Dim>& other = equalMassPartner(fluids, fluid);
    fluid.particleVolume = other.particleVolume * (other.settings.density / fluid.settings.density);
  }
}

template <int Dim>
std::vector<Vec<Dim>> allPoints(const std::vector<FluidFill<Dim>>& fluids) {
  std::vector<Vec<Dim>> points;
  for (const auto& fluid : fluids)
    points.insert(points.end(), fluid.points.begin(), fluid.points.end());
  return points;
}

template struct FluidFill<1>;
template struct FluidFill<2>;
template struct FluidFill<3>;
template Lattice<1> latticeWith(const FluidFill<1>&, double, const SceneFrame<1>&);
template FluidFill<1> prepareFluid(const FluidSettings&, GeometryPtr<1>, DensityProfilePtr<1>,
                                   const SceneFrame<1>&, const Warn&);
template void fillFluids(std::vector<FluidFill<1>>&, const SceneFrame<1>&);
template std::vector<Vec<1>> allPoints(const std::vector<FluidFill<1>>&);
template Lattice<2> latticeWith(const FluidFill<2>&, double, const SceneFrame<2>&);
template FluidFill<2> prepareFluid(const FluidSettings&, GeometryPtr<2>, DensityProfilePtr<2>,
                                   const SceneFrame<2>&, const Warn&);
template void fillFluids(std::vector<FluidFill<2>>&, const SceneFrame<2>&);
template std::vector<Vec<2>> allPoints(const std::vector<FluidFill<2>>&);
template Lattice<3> latticeWith(const FluidFill<3>&, double, const SceneFrame<3>&);
template FluidFill<3> prepareFluid(const FluidSettings&, GeometryPtr<3>, DensityProfilePtr<3>,
                                   const SceneFrame<3>&, const Warn&);
template void fillFluids(std::vector<FluidFill<3>>&, const SceneFrame<3>&);
template std::vector<Vec<3>> allPoints(const std::vector<FluidFill<3>>&);

}  // namespace plenum
