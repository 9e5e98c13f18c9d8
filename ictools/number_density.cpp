// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/number_density.hpp"

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
constexpr double blur = 0.7;

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

/// Cells whose edges are the spacing times `factor`.
template <int Dim>
CellSizes<Dim> sizesOf(const FluidFill<Dim>& fluid, double factor) {
  CellSizes<Dim> sizes;
  sizes.coarsest = factor * plainEdge(fluid);
  sizes.at = [resolution = fluid.resolution, coarsest = sizes.coarsest](
                 std::span<const Vec<Dim>> centers, std::span<double> edges) {
    std::fill(edges.begin(), edges.end(), 1.0);
    if (resolution) resolution->at(centers, edges);
    for (double& edge : edges) edge *= coarsest;
  };
  return sizes;
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

/// Cells for an estimate: two spacings long, over which a spacing grows by a fifth at the usual
/// growth, and of any length where it does not grow.
template <int Dim>
CellSizes<Dim> estimateSizes(const FluidFill<Dim>& fluid) {
  CellSizes<Dim> sizes;
  sizes.most = 100000;  // the error of so many samples is below a percent
  const double longest = 2 * plainEdge(fluid);
  sizes.coarsest =
      std::max(longest, std::pow(fluid.box.volume() / static_cast<double>(sizes.most), 1.0 / Dim));
  sizes.at = [resolution = fluid.resolution, longest](std::span<const Vec<Dim>> centers,
                                                      std::span<double> edges) {
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

/// The edge at which the densest place of a profile has two cells a particle, along each axis.
template <int Dim>
double fineEdge(const FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame) {
  const Cells<Dim> coarse = cellsOf(fluid, sizesOf(fluid, 1), frame);
  if (coarse.centers.empty())
    at(fluid.settings.node, "region").fail("gets no particle; a smaller spacing is needed");
  const auto density = densitiesAt<Dim>(*fluid.profile, coarse.centers, nodeOf(fluid));
  const double most = *std::max_element(density.begin(), density.end());
  const double edge =
      0.5 * plainEdge(fluid) * std::pow(std::min(1.0, fluid.settings.density / most), 1.0 / Dim);
  constexpr double mostCells = 4e8;  // of 24 bytes and two numbers of 8: 16 GB
  const double expected =
      std::accumulate(coarse.volumes.begin(), coarse.volumes.end(), 0.0) / power<Dim>(edge);
  if (expected > mostCells)
    nodeOf(fluid).fail(
        fmt::format("asks for {:.3g} cells to find places in, more than {:g}; a larger spacing or "
                    "smaller contrast is needed",
                    expected, mostCells));
  return edge;
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
    const Box<Dim> cell{Vec<Dim>::filled(-half), Vec<Dim>::filled(half), {}};
    while (next < passed && points.size() < n) {
      Vec<Dim> x = frame.domain.wrap(cells.centers[k] + random.pointIn(cell));
      if (fluid.region && fluid.region->signedDistance(x) > -roundOff) x = cells.centers[k];
      points.push_back(x);
      next = static_cast<double>(points.size()) + random.number();
    }
  }
  // Round-off of the sum may leave the last one out.
  while (points.size() < n) points.push_back(cells.centers.back());
  return points;
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
    fluid.expected = fluid.settings.positions ? static_cast<double>(fluid.points.size())
                                              : std::min(fluid.volume.value, fluid.box.volume()) /
                                                    fluid.lattice.cellVolume();
    if (!resolution) continue;
    const Cells<Dim> cells = cellsOf(fluid, estimateSizes(fluid), frame);
    if (cells.centers.empty()) continue;  // says so when it is filled
    const auto wanted = particlesIn(fluid, cells);
    fluid.expected = volumeOver(fluid, cells) * std::accumulate(wanted.begin(), wanted.end(), 0.0);
    markTouched(*resolution, cells, std::sqrt(Dim) * plainEdge(fluid), isTouched);
    if (fluid.expected >= mostParticles)
      nodeOf(fluid).fail(
          fmt::format("would hold {:.3g} particles with its [[refine]], more than 2^31; a larger "
                      "spacing of the case or of [[refine]] is needed",
                      fluid.expected));
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
void fillByNumberDensity(FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame, Random random) {
  CellSizes<Dim> sizes = sizesOf(fluid, 1 / cellsPerSpacing);
  if (!fluid.resolution) {
    const double edge = fineEdge(fluid, frame);
    sizes.coarsest = edge;
    sizes.at = [edge](auto, std::span<double> edges) {
      std::fill(edges.begin(), edges.end(), 2 * edge);  // none is cut again
    };
  }
  const Cells<Dim> cells = cellsOf(fluid, sizes, frame);
  if (cells.centers.empty())
    at(fluid.settings.node, "region").fail("gets no particle; a smaller spacing is needed");
  const auto wanted = particlesIn(fluid, cells);
  const double total =
      volumeOver(fluid, cells) * std::accumulate(wanted.begin(), wanted.end(), 0.0);
  if (total >= mostParticles)
    nodeOf(fluid).fail(fmt::format(
        "asks for {:.3g} particles, more than 2^31; a larger spacing is needed", total));
  const double n = std::max(1.0, std::round(total));
  const double share = total / n;
  if (fluid.resolution)
    fluid.volumeFactor = share;
  else
    fluid.particleMass = share * fluid.settings.density * fluid.lattice.cellVolume();
  const auto count = static_cast<std::size_t>(n);
  if (fluid.settings.lattice == "random") {
    fluid.points = randomPlaces(fluid, cells, wanted, count, frame, random);
  } else {
    const auto shares = sharesOf(cells, wanted, count);
    fluid.points = middles(fluid, cells, shares, surfaceRoundOff * frame.spacing);
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
                                             const Box<Dim>&);
PLENUM_NUMBER_DENSITY(1)
PLENUM_NUMBER_DENSITY(2)
PLENUM_NUMBER_DENSITY(3)

}  // namespace plenum
