// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/number_density.hpp"

#include "engine/ordered_sum.hpp"
#include "ictools/cells.hpp"
#include "particles/number.hpp"
#include "particles/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plenum {

namespace {

/// Densities are blurred over that many spacings to both sides along each axis, so that where they
/// jump, a particle's volume does not jump with each of its moves.
constexpr double blur = 0.5;

/// Of a particle's share, along an axis, where spacings follow a refinement: five cells in 3-D.
constexpr double cellsPerSpacing = 1.7;

constexpr double mostParticles = 2147483648.0;  // 2^31: particles are numbered with 32 bits

/// The key that makes a fluid's spacing vary.
template <int Dim>
const CaseNode& nodeOf(const FluidFill<Dim>& fluid) {
  return at(fluid.settings.node, fluid.resolution ? "region" : "profile");
}

/// Edge of a cube with the volume of a lattice's cell where nothing is refined [m].
template <int Dim>
double plainEdge(const FluidFill<Dim>& fluid) {
  return std::pow(fluid.lattice.cellVolume(), 1.0 / Dim);
}

/// Writes the edge that a particle's volume has at each center over that of a lattice's cell: the
/// finest of the fluid, `otherwise`, where a profile has no density.
template <int Dim>
void edgeRatios(const FluidFill<Dim>& fluid, double otherwise, std::span<const Vec<Dim>> centers,
                std::span<double> ratios) {
  if (fluid.resolution) return fluid.resolution->at(centers, ratios);
  fluid.profile->at(centers, ratios);
  for (double& ratio : ratios) {
    const bool isDensity = ratio > 0 && std::isfinite(ratio);
    ratio = isDensity ? std::pow(fluid.settings.density / ratio, 1.0 / Dim) : otherwise;
  }
}

template <int Dim>
Cells<Dim> cellsOf(const FluidFill<Dim>& fluid, const CellSizes<Dim>& sizes,
                   const SceneFrame<Dim>& frame) {
  return cellsOf(fluid.region.get(), fluid.box, sizes, surfaceRoundOff * frame.spacing);
}

/// Particles wanted in each cell: the integral of 1/V.
template <int Dim>
std::vector<double> particlesIn(const FluidFill<Dim>& fluid, const Cells<Dim>& cells) {
  const double plain = fluid.lattice.cellVolume(), reference = fluid.settings.density;
  auto particles = fluid.resolution
                       ? ratiosAt<Dim>(*fluid.resolution, cells.centers)
                       : densitiesAt<Dim>(*fluid.profile, cells.centers, nodeOf(fluid));
  forEachIndex(particles.size(), [&](std::size_t k) {
    const double perPlain =
        fluid.resolution ? 1 / power<Dim>(particles[k]) : particles[k] / reference;
    particles[k] = cells.volumes[k] / plain * perPlain;
  });
  return particles;
}

/// Cells for an estimate. Of a profile: one for each cell of the lattice. Of a refinement: two
/// spacings long, over which a spacing grows by a fifth at the usual growth, and of any length
/// where it does not grow.
template <int Dim>
CellSizes<Dim> estimateSizes(const FluidFill<Dim>& fluid) {
  const double longest = (fluid.resolution ? 2 : 1) * plainEdge(fluid);
  CellSizes<Dim> sizes;
  sizes.most = 100000;  // the error of so many samples is below a percent
  sizes.coarsest =
      std::max(longest, std::pow(fluid.box.volume() / static_cast<double>(sizes.most), 1.0 / Dim));
  sizes.at = [resolution = fluid.resolution, longest](std::span<const Vec<Dim>> centers,
                                                      std::span<double> edges) {
    std::fill(edges.begin(), edges.end(), longest);
    if (!resolution) return;
    std::vector<double> plain(centers.size());
    resolution->plainAround(centers, plain);
    resolution->at(centers, edges);
    for (std::size_t k = 0; k < edges.size(); ++k)
      edges[k] = std::max(longest * edges[k], 2 / std::sqrt(Dim) * plain[k]);
  };
  return sizes;
}

/// By which the cells' volumes are to be multiplied for the region's exact one.
template <int Dim>
double volumeOver(const FluidFill<Dim>& fluid, const Cells<Dim>& cells) {
  if (fluid.isCut || !fluid.region) return 1;
  return fluid.volume.value / std::accumulate(cells.volumes.begin(), cells.volumes.end(), 0.0);
}

/// The cells that a fluid is filled by: some for each particle. Those of a profile are at first no
/// larger than a cell of the lattice, so that nothing of that size is missed.
template <int Dim>
CellSizes<Dim> fillSizes(const FluidFill<Dim>& fluid, double finest) {
  const double edge = plainEdge(fluid) / cellsPerSpacing;
  CellSizes<Dim> sizes;
  sizes.coarsest = fluid.resolution ? edge : plainEdge(fluid);
  sizes.at = [&fluid, edge, finest](std::span<const Vec<Dim>> centers, std::span<double> edges) {
    edgeRatios(fluid, finest, centers, edges);
    for (double& here : edges) here *= edge;
  };
  return sizes;
}

/// A share of the row of cells: the place of one particle.
template <int Dim>
struct Share {
  Vec<Dim> sum{};        ///< of centers, by part
  double filled = 0;     ///< of the particle
  std::size_t most = 0;  ///< the cell in its middle
};

/// Divides the row of cells into `n` shares of equal number of particles.
template <int Dim>
std::vector<Share<Dim>> sharesOf(const Cells<Dim>& cells, const std::vector<double>& particles,
                                 std::size_t n) {
  const double total = std::accumulate(particles.begin(), particles.end(), 0.0);
  std::vector<Share<Dim>> shares(n);
  std::size_t share = 0;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    for (double rest = particles[k] / total * static_cast<double>(n); rest > 0;) {
      Share<Dim>& here = shares[share];
      const bool isLast = share + 1 == n;  // has what round-off leaves
      const double part = isLast ? rest : std::min(rest, 1 - here.filled);
      if (here.filled < 0.5) here.most = k;
      here.sum += part * cells.centers[k];
      here.filled += part;
      rest -= part;
      if (!isLast && here.filled >= 1 - 1e-12) ++share;
    }
  }
  return shares;
}

/// The middle of each share; the cell in its middle where that is outside of the region.
template <int Dim>
std::vector<Vec<Dim>> middles(const FluidFill<Dim>& fluid, const Cells<Dim>& cells,
                              const std::vector<Share<Dim>>& shares, double roundOff) {
  std::vector<Vec<Dim>> points;
  for (const auto& share : shares) points.push_back(share.sum / share.filled);
  if (!fluid.region) return points;
  const auto distances = signedDistances<Dim>(*fluid.region, points);
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!(distances[k] < -roundOff)) points[k] = cells.centers[shares[k].most];
  return points;
}

/// A random place in each share: in a cell of it, within half an edge around its center.
template <int Dim>
std::vector<Vec<Dim>> randomPlaces(const FluidFill<Dim>& fluid, const Cells<Dim>& cells,
                                   const std::vector<double>& particles, std::size_t n,
                                   const SceneFrame<Dim>& frame, Random random) {
  const double total = std::accumulate(particles.begin(), particles.end(), 0.0);
  const double roundOff = surfaceRoundOff * frame.spacing;
  std::vector<Vec<Dim>> points;
  double passed = 0, next = random.number();  // in particles
  for (std::size_t k = 0; k < particles.size(); ++k) {
    passed += particles[k] / total * static_cast<double>(n);
    const double half = 0.5 * std::pow(cells.volumes[k], 1.0 / Dim);
    while (next < passed && points.size() < n) {
      // Around the center, which is inside: nearer and nearer to it until the place is inside, too.
      Vec<Dim> x;
      for (double reach = half;; reach *= 0.8) {
        const Box<Dim> cell{Vec<Dim>::filled(-reach), Vec<Dim>::filled(reach), {}};
        x = frame.domain.wrap(cells.centers[k] + random.pointIn(cell));
        if (!fluid.region || fluid.region->signedDistance(x) < -roundOff) break;
        if (reach < 1e-3 * half) {
          x = cells.centers[k];
          break;
        }
      }
      points.push_back(x);
      next = static_cast<double>(points.size()) + random.number();
    }
  }
  // Round-off of the sum may leave the last one out.
  while (points.size() < n) points.push_back(cells.centers.back());
  return points;
}

/// What a fluid is filled by.
template <int Dim>
struct Portions {
  Cells<Dim> cells;
  std::vector<double> wanted;  ///< particles in each
  std::size_t count = 0;       ///< of particles
};

/// Sets the share of a particle, too: its mass, or its volume over that of its lattice's cell.
template <int Dim>
Portions<Dim> portionsOf(FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame) {
  CellSizes<Dim> sizes = fillSizes(fluid, fluid.finest);
  // Five a particle are usual; more are for thin parts, and for estimates that missed something.
  sizes.limit = static_cast<std::size_t>(100 * fluid.expected + 1e6);
  Portions<Dim> portions{cellsOf(fluid, sizes, frame), {}, 0};
  const Cells<Dim>& cells = portions.cells;
  if (!cells.isComplete)
    nodeOf(fluid).fail(
        fmt::format("asks for places far finer than the {:.3g} particles that were estimated; "
                    "does it diverge somewhere? A larger spacing or a limit of the density is "
                    "needed",
                    fluid.expected));
  if (cells.centers.empty())
    at(fluid.settings.node, "region").fail("gets no particle; a smaller spacing is needed");
  portions.wanted = particlesIn(fluid, cells);
  const double total =
      volumeOver(fluid, cells) *
      orderedSum<double>(portions.wanted.size(), [&](std::size_t k) { return portions.wanted[k]; });
  const double n = std::max(1.0, std::round(total));
  const double share = total / n;
  if (fluid.resolution)
    fluid.volumeFactor = share;
  else
    fluid.particleMass = share * fluid.settings.density * fluid.lattice.cellVolume();
  portions.count = static_cast<std::size_t>(n);
  return portions;
}

/// Volumes by a profile's density, averaged around each point.
template <int Dim>
std::vector<double> volumesOfProfile(const FluidFill<Dim>& fluid, std::span<const Vec<Dim>> points,
                                     const Box<Dim>& domain) {
  auto volumes = densitiesAt<Dim>(*fluid.profile, points, nodeOf(fluid));
  constexpr std::size_t batch = 512, nAround = 2 * Dim;
  parallelFor((points.size() + batch - 1) / batch, [&](std::size_t b) {
    const std::size_t first = b * batch, count = std::min(batch, points.size() - first);
    std::vector<Vec<Dim>> around;  // all at once: a formula is parsed for each call
    for (std::size_t k = first; k < first + count; ++k) {
      const double reach = blur * std::pow(fluid.particleMass / volumes[k], 1.0 / Dim);
      for (int side = 0; side < static_cast<int>(nAround); ++side) {
        Vec<Dim> x = points[k];
        x[side / 2] += side % 2 == 0 ? reach : -reach;
        around.push_back(domain.wrap(x));
      }
    }
    std::vector<double> density(around.size());
    fluid.profile->at(around, density);
    for (std::size_t k = 0; k < count; ++k) {
      double sum = volumes[first + k], n = 1;
      for (std::size_t side = 0; side < nAround; ++side) {
        const double rho = density[k * nAround + side];
        if (!(rho > 0 && std::isfinite(rho))) continue;  // a table may end there
        sum += rho;
        n += 1;
      }
      volumes[first + k] = fluid.particleMass * n / sum;
    }
  });
  return volumes;
}

/// Most particles in a cell of the lattice.
template <int Dim>
double finestShare(const FluidFill<Dim>& fluid, const Cells<Dim>& cells,
                   const std::vector<double>& particles) {
  double most = 1;
  for (std::size_t k = 0; k < particles.size(); ++k)
    most = std::max(most, particles[k] / cells.volumes[k] * fluid.lattice.cellVolume());
  return most;
}

/// Marks the refinements whose place some of the cells reach; all if not all cells are there.
template <int Dim>
void markTouched(const Resolution<Dim>& resolution, const Cells<Dim>& cells, double reach,
                 std::vector<bool>& isTouched) {
  std::vector<double> distance(cells.centers.size());
  for (std::size_t r = 0; r < isTouched.size(); ++r) {
    resolution.refinements()[r].distances(cells.centers, distance);
    if (cells.isSampled || std::ranges::any_of(distance, [&](double d) { return d <= reach; }))
      isTouched[r] = true;
  }
}

}  // namespace

template <int Dim>
void countExpected(std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame,
                   const Warn& warn) {
  const ResolutionPtr<Dim> resolution = fluids.front().resolution;
  std::vector<bool> isTouched(resolution ? resolution->refinements().size() : 0);
  for (FluidFill<Dim>& fluid : fluids) {
    const double plain =
        std::min(fluid.volume.value, fluid.box.volume()) / fluid.lattice.cellVolume();
    fluid.expected = fluid.isPlaced ? static_cast<double>(fluid.points.size()) : plain;
    if (!fluid.spacingVaries()) continue;
    const Cells<Dim> cells = cellsOf(fluid, estimateSizes(fluid), frame);
    if (cells.centers.empty()) continue;  // says so when it is filled
    const auto wanted = particlesIn(fluid, cells);
    fluid.expected = volumeOver(fluid, cells) * std::accumulate(wanted.begin(), wanted.end(), 0.0);
    fluid.finest = fluid.resolution ? fluid.resolution->finest()
                                    : std::pow(finestShare(fluid, cells, wanted), -1.0 / Dim);
    if (resolution) markTouched(*resolution, cells, std::sqrt(Dim) * plainEdge(fluid), isTouched);
    if (fluid.expected >= mostParticles)
      nodeOf(fluid).fail(
          fmt::format("asks for {:.3g} particles with its {}, more than 2^31; a "
                      "larger spacing of the case{} is needed",
                      fluid.expected, resolution ? "[[refine]]" : "profile",
                      resolution ? " or of [[refine]]" : ""));
  }
  for (std::size_t r = 0; r < isTouched.size(); ++r) {
    const RefineSettings& settings = resolution->refinements()[r].settings();
    if (!isTouched[r])
      warn(
          fmt::format("{}: no fluid touches the place that is refined, {}; name another region, "
                      "or leave this [[refine]] out",
                      at(settings.node, settings.regionKey()).where(),
                      resolution->refinements()[r].region().describe()));
  }
}

template <int Dim>
void setShares(FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame) {
  portionsOf(fluid, frame);
}

template <int Dim>
void fillByNumberDensity(FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame, Random random) {
  const Portions<Dim> portions = portionsOf(fluid, frame);
  if (fluid.settings.lattice == "random") {
    fluid.points =
        randomPlaces(fluid, portions.cells, portions.wanted, portions.count, frame, random);
  } else {
    const auto shares = sharesOf(portions.cells, portions.wanted, portions.count);
    fluid.points = middles(fluid, portions.cells, shares, surfaceRoundOff * frame.spacing);
  }
}

template <int Dim>
std::vector<double> targetVolumes(const FluidFill<Dim>& fluid, std::span<const Vec<Dim>> points,
                                  const Box<Dim>& domain) {
  if (!fluid.spacingVaries()) return std::vector<double>(points.size(), fluid.meanVolume());
  if (!fluid.resolution) return volumesOfProfile(fluid, points, domain);
  auto volumes = ratiosAt<Dim>(*fluid.resolution, points);
  for (double& ratio : volumes)
    ratio = fluid.volumeFactor * fluid.lattice.cellVolume() * power<Dim>(ratio);
  return volumes;
}

#define PLENUM_NUMBER_DENSITY(Dim)                                                                \
  template void countExpected(std::vector<FluidFill<Dim>>&, const SceneFrame<Dim>&, const Warn&); \
  template void fillByNumberDensity(FluidFill<Dim>&, const SceneFrame<Dim>&, Random);             \
  template std::vector<double> targetVolumes(const FluidFill<Dim>&, std::span<const Vec<Dim>>,    \
                                             const Box<Dim>&);                                    \
  template void setShares(FluidFill<Dim>&, const SceneFrame<Dim>&);
PLENUM_NUMBER_DENSITY(1)
PLENUM_NUMBER_DENSITY(2)
PLENUM_NUMBER_DENSITY(3)

}  // namespace plenum
