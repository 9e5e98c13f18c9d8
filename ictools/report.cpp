// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/report.hpp"

#include "engine/engine.hpp"
#include "engine/measures.hpp"
#include "engine/ordered_sum.hpp"
#include "engine/point_search.hpp"
#include "ictools/neighbour_sums.hpp"
#include "ictools/profile_errors.hpp"
#include "particles/case_settings.hpp"
#include "particles/number.hpp"
#include "particles/parallel.hpp"
#include "particles/self_term.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

constexpr double overlapping = 0.5, isolated = 1.5;  // [d_ref]

/// Sums over neighbours of the fluid particles, in the order of `particles`.
template <int Dim>
struct QualitySums {
  std::vector<double> density;           ///< [kg/m^d]
  std::vector<double> kernelSum;         ///< 1 where space is filled
  std::vector<Vec<Dim>> kernelGradient;  ///< [1/m], towards the particles
};

/// What the run that the set is made for takes from summed densities, in m h^-d.
template <int Dim>
double selfTermOf(const SceneInfo<Dim>& info) {
  if (info.caseText.empty()) return 0;
  const CaseSettings settings = readCase(CaseNode::parse(info.caseText, info.caseName));
  return selfTermCorrection(settings.solverOrDefaults(), Dim);
}

/// Sorts `particles` for the engine.
template <int Dim>
QualitySums<Dim> qualitySums(const Scene<Dim>& scene, ParticleSet<Dim>& particles) {
  typename Engine<Dim>::Options options;
  options.precision = Precision::doubled;
  options.units = Units::near(scene.info.smoothingLength, particles[field::mass][0], 1);
  options.adaptive = true;
  Engine<Dim> engine(scene.info.domain, options);
  engine.update(particles);
  engine.run(neighbourPass<Dim>(NeighbourSum::quality,
                                {KernelId::named(scene.info.kernel), 0, true}, options.units),
             particles);
  QualitySums<Dim> sums{engine.sums(field::density), engine.sums(field::kernelSum),
                        engine.sums(field::kernelGradient)};
  if (const double selfTerm = selfTermOf(scene.info); selfTerm != 0)
    for (std::size_t i = 0; i < sums.density.size(); ++i)
      sums.density[i] -=
          selfTerm * particles[field::mass][i] / power<Dim>(particles[field::smoothingLength][i]);
  return sums;
}

/// Whether nobody stands where the gradient of the kernel sum misses somebody: no particle within
/// two spacings, its own or the other's, and 45 degrees of the direction into the void (after
/// Marrone et al. 2010, doi 10.1016/j.jcp.2010.01.019). `all` reaches two of the largest spacings.
template <int Dim>
bool isAtFreeSurface(std::size_t i, const Vec<Dim>& x, const Vec<Dim>& gradient,
                     std::span<const double> spacing, const PointSearch<Dim>& all) {
  // A plane surface half a spacing away gives .3 to .6 at usual h/d.
  constexpr double noSurface = 0.12;
  const double length = norm(gradient);
  if (length * spacing[i] < noSurface) return false;
  const Vec<Dim> intoVoid = -gradient / length;
  bool covered = false;
  all.around(x, [&](std::uint32_t j, const Vec<Dim>& d, double d2) {
    const double reach = 2 * std::max(spacing[i], spacing[j]);
    covered |= d2 > 0 && d2 < reach * reach && dot(d, intoVoid) > std::sqrt(0.5 * d2);
  });
  return !covered;
}

/// Marks the particles that have one of `others` within their reach [m].
template <int Dim>
std::vector<std::uint8_t> near(std::span<const Vec<Dim>> particles, std::span<const double> reach,
                               std::span<const Vec<Dim>> others, const Box<Dim>& domain) {
  std::vector<std::uint8_t> result(particles.size());
  if (others.empty() || particles.empty()) return result;
  const PointSearch<Dim> search(others, domain, *std::max_element(reach.begin(), reach.end()));
  forEachIndex(particles.size(), [&](std::size_t i) {
    search.around(particles[i], [&](std::uint32_t, const Vec<Dim>&, double d2) {
      if (d2 < reach[i] * reach[i]) result[i] = 1;
    });
  });
  return result;
}

/// Particles that have one of another fluid within their reach [m].
template <int Dim>
std::vector<std::uint8_t> nearOtherFluid(const ParticleSet<Dim>& particles, const Box<Dim>& domain,
                                         std::span<const double> reach) {
  std::vector<std::uint8_t> result(particles.nFluid());
  if (!particles.has(field::material)) return result;
  const auto material = particles[field::material];
  const auto [least, most] = std::minmax_element(material.begin(), material.end());
  if (material.empty() || *least == *most) return result;
  const auto position = particles[field::position];
  const PointSearch<Dim> search(position.first(particles.nFluid()), domain,
                                *std::max_element(reach.begin(), reach.end()));
  forEachIndex(result.size(), [&](std::size_t i) {
    search.around(position[i], [&](std::uint32_t j, const Vec<Dim>&, double d2) {
      if (material[j] != material[i] && d2 < reach[i] * reach[i]) result[i] = 1;
    });
  });
  return result;
}

/// d_ref where smoothing lengths are that of the scene, in proportion elsewhere [m].
template <int Dim>
std::vector<double> localSpacings(const SceneInfo<Dim>& info, const ParticleSet<Dim>& particles) {
  std::vector<double> spacing(particles.size());
  for (std::size_t i = 0; i < spacing.size(); ++i)
    spacing[i] = info.spacing * particles[field::smoothingLength][i] / info.smoothingLength;
  return spacing;
}

/// How far kernels reach behind the surface of each wall [m]: those of the fluid particles that
/// stand within a smoothing length of its particles, or that of the scene if all are the same.
template <int Dim>
std::vector<double> reachBehindWalls(const Scene<Dim>& scene) {
  const SceneInfo<Dim>& info = scene.info;
  const ParticleSet<Dim>& particles = scene.particles;
  const auto length = particles[field::smoothingLength].first(particles.nFluid());
  const auto [least, most] = std::ranges::minmax(length);
  if (most - least <= 1e-9 * most || info.walls.empty() || !particles.has(field::wallDistance))
    return std::vector<double>(info.walls.size(), 2 * info.smoothingLength);
  std::vector<double> reach(info.walls.size());
  const auto position = particles[field::position];
  const PointSearch<Dim> walls(position.subspan(length.size()), info.domain, most);
  for (std::size_t i = 0; i < length.size(); ++i) {
    double nearest = length[i] * length[i], distance = 0;  // squared; to the surface
    std::size_t wall = info.walls.size();
    walls.around(position[i], [&](std::uint32_t j, const Vec<Dim>& d, double d2) {
      if (d2 > nearest) return;
      nearest = d2;
      wall = static_cast<std::size_t>(particles[field::wall][j]);
      distance = -dot(d, particles[field::normal][j]) - particles[field::wallDistance][j];
    });
    if (wall < reach.size())
      reach[wall] = std::max(reach[wall], 2 * length[i] - std::max(0.0, distance));
  }
  return reach;
}

template <int Dim>
std::vector<Place> placesOf(const Scene<Dim>& scene, const ParticleSet<Dim>& particles,
                            const QualitySums<Dim>& sums) {
  const Box<Dim>& domain = scene.info.domain;
  const auto position = particles[field::position];
  const auto fluid = position.first(particles.nFluid());
  const std::vector<double> spacing = localSpacings(scene.info, particles);
  std::vector<double> reach(fluid.size());
  for (std::size_t i = 0; i < reach.size(); ++i)
    reach[i] = 2 * particles[field::smoothingLength][i];
  const PointSearch<Dim> all(position, domain,
                             2 * *std::max_element(spacing.begin(), spacing.end()));
  std::vector<Vec<Dim>> surface;
  for (std::size_t i = 0; i < fluid.size(); ++i)
    if (isAtFreeSurface<Dim>(i, fluid[i], sums.kernelGradient[i], spacing, all))
      surface.push_back(fluid[i]);
  const auto atWall = near<Dim>(fluid, reach, position.subspan(fluid.size()), domain);
  const auto atSurface = near<Dim>(fluid, reach, surface, domain);
  const auto atFluid = nearOtherFluid<Dim>(particles, domain, reach);
  std::vector<Place> places(fluid.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = atWall[i]      ? Place::wall
                : atSurface[i] ? Place::freeSurface
                : atFluid[i]   ? Place::interface
                               : Place::inside;
  return places;
}

/// What is summed over the particles of one kind of place.
struct PlaceSums {
  double n = 0, error = 0, square = 0, worst = 0, kernelSum = 0, gradient = 0, largest = 0;
  PlaceSums& operator+=(const PlaceSums& b) {
    n += b.n;
    error += b.error;
    square += b.square;
    kernelSum += b.kernelSum;
    gradient += b.gradient;
    worst = std::max(worst, b.worst);
    largest = std::max(largest, b.largest);
    return *this;
  }
};

template <int Dim>
PlaceFigures figuresAt(Place place, const std::vector<Place>& places,
                       const std::vector<double>& error, const QualitySums<Dim>& sums,
                       const std::vector<double>& spacing) {
  const auto total = orderedSum<PlaceSums>(places.size(), [&](std::size_t i) {
    if (places[i] != place) return PlaceSums{};
    const double gradient = norm(sums.kernelGradient[i]) * spacing[i];
    return PlaceSums{1,        error[i], error[i] * error[i], std::abs(error[i]), sums.kernelSum[i],
                     gradient, gradient};
  });
  PlaceFigures figures;
  figures.n = static_cast<std::size_t>(total.n);
  if (figures.n == 0) return figures;
  figures.bias = total.error / total.n;
  figures.scatter = std::sqrt(std::max(0.0, total.square / total.n - figures.bias * figures.bias));
  figures.worst = total.worst;
  figures.kernelSum = total.kernelSum / total.n;
  figures.kernelGradient = total.gradient / total.n;
  figures.largestGradient = total.largest;
  return figures;
}

Histogram histogram(const std::vector<double>& values, double lower, double width, int nBins) {
  Histogram h{lower, width, std::vector<double>(static_cast<std::size_t>(nBins))};
  for (const double value : values) {
    const double bin = std::clamp(std::floor((value - lower) / width), 0.0, nBins - 1.0);
    h.share[static_cast<std::size_t>(bin)] += 1 / static_cast<double>(values.size());
  }
  return h;
}

/// Bins that show the bulk of the errors: three standard deviations on both sides of the mean.
Histogram errorHistogram(const std::vector<double>& error, const std::vector<Place>& places,
                         const PlaceFigures& inside) {
  std::vector<double> values;
  for (std::size_t i = 0; i < error.size(); ++i)
    if (places[i] == Place::inside) values.push_back(error[i]);
  constexpr int nBins = 40;
  const double half = std::max(3 * inside.scatter, 1e-9);
  return histogram(values, inside.bias - half, 2 * half / nBins, nBins);
}

template <int Dim>
std::vector<FluidMass> massesOf(const Scene<Dim>& scene) {
  const auto figure = [&](const std::string& name) {
    for (const auto& [key, value] : scene.info.quality)
      if (key == name) return value;
    return 0.0;
  };
  const auto mass = scene.particles[field::mass];
  std::vector<FluidMass> masses;
  for (std::size_t m = 0; m < scene.info.materials.size(); ++m) {
    const bool isAlone = !scene.particles.has(field::material);
    const auto isHere = [&](std::size_t i) {
      return isAlone || scene.particles[field::material][i] == static_cast<std::int32_t>(m);
    };
    FluidMass fluid{scene.info.materials[m].name, 0, 0, 0};
    fluid.mass = orderedSum<double>(scene.particles.nFluid(),
                                    [&](std::size_t i) { return isHere(i) ? mass[i] : 0; });
    for (std::size_t i = 0; i < scene.particles.nFluid(); ++i) fluid.n += isHere(i);
    fluid.expected = figure(fluid.name + ": density x volume");
    masses.push_back(fluid);
  }
  return masses;
}

/// Volume of a particle that has as many neighbours within the scene's support as the mean particle
/// has within its own [m^d].
template <int Dim>
double meanVolume(const Scene<Dim>& scene) {
  const auto mass = scene.particles[field::mass], density = scene.particles[field::density];
  const auto length = scene.particles[field::smoothingLength];
  const double n = static_cast<double>(scene.particles.nFluid());
  return orderedSum<double>(scene.particles.nFluid(),
                            [&](std::size_t i) {
                              return mass[i] / density[i] *
                                     power<Dim>(scene.info.smoothingLength / length[i]);
                            }) /
         n;
}

template <int Dim>
void judgeDensity(const Scene<Dim>& scene, const std::vector<DensityProfilePtr<Dim>>& profiles,
                  Report& report) {
  ParticleSet<Dim> particles = scene.particles;  // the engine sorts
  const QualitySums<Dim> sums = qualitySums(scene, particles);
  const std::vector<Place> places = placesOf(scene, particles, sums);
  const std::vector<double> spacing = localSpacings(scene.info, particles);
  const auto density = particles[field::density];
  std::vector<double> error(particles.nFluid());
  forEachIndex(error.size(), [&](std::size_t i) { error[i] = sums.density[i] / density[i] - 1; });
  for (std::size_t p = 0; p < nPlaces; ++p)
    report.places[p] = figuresAt(Place(p), places, error, sums, spacing);
  report.densityHistogram =
      errorHistogram(error, places, report.places[static_cast<std::size_t>(Place::inside)]);
  std::vector<std::uint8_t> inside(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) inside[i] = places[i] == Place::inside;
  report.profile = profileErrors<Dim>(KernelId::named(scene.info.kernel), particles,
                                      scene.info.domain, sums.density, inside, profiles);
}

template <int Dim>
void judgeSpacing(const Scene<Dim>& scene, Report& report) {
  const auto around = neighbourhoods<Dim>(scene.particles, scene.info.domain,
                                          localSpacings(scene.info, scene.particles));
  const double share = 1 / static_cast<double>(around.size());
  SpacingFigures& figures = report.nearest;
  figures.least = std::numeric_limits<double>::infinity();
  std::vector<double> nearest;
  double order = 0, nOrdered = 0;
  for (const Neighbourhood& here : around) {
    nearest.push_back(here.nearest);
    figures.least = std::min(figures.least, here.nearest);
    figures.largest = std::max(figures.largest, here.nearest);
    figures.mean += share * here.nearest;
    figures.below01 += here.nearest < 0.1 ? share : 0;
    figures.below05 += here.nearest < 0.5 ? share : 0;
    figures.below085 += here.nearest < 0.85 ? share : 0;
    report.nOverlaps += here.nearest < overlapping;
    report.nIsolated += here.nearest > isolated;
    if (std::isnan(here.bondOrder)) continue;
    order += here.bondOrder;
    nOrdered += 1;
  }
  report.bondOrder = nOrdered > 0 ? order / nOrdered : 0;
  report.nearestHistogram = histogram(nearest, 0, 0.05, 40);
}

}  // namespace

template <int Dim>
Report reportOn(const Scene<Dim>& scene, const std::vector<DensityProfilePtr<Dim>>& profiles) {
  const SceneInfo<Dim>& info = scene.info;
  Report report;
  report.title = info.title;
  report.kernel = info.kernel;
  report.dimension = Dim;
  report.spacing = info.spacing;
  report.smoothingLength = info.smoothingLength;
  report.nFluid = scene.particles.nFluid();
  report.nWalls = scene.particles.nWalls();
  report.masses = massesOf(scene);
  judgeSpacing(scene, report);
  const std::vector<double> reach = reachBehindWalls(scene);
  for (std::size_t w = 0; w < reach.size(); ++w)
    report.walls.push_back({info.walls[w].name, info.walls[w].thickness, reach[w]});
  judgeDensity(scene, profiles, report);
  report.pairing =
      forecastPairing(KernelId::named(info.kernel), Dim, info.smoothingLength, meanVolume(scene));
  return report;
}

template Report reportOn(const Scene<1>&, const std::vector<DensityProfilePtr<1>>&);
template Report reportOn(const Scene<2>&, const std::vector<DensityProfilePtr<2>>&);
template Report reportOn(const Scene<3>&, const std::vector<DensityProfilePtr<3>>&);

}  // namespace plenum
