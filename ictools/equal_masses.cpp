// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/equal_masses.hpp"

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

const std::string& plainLattice(int dimension) {
  static const std::string names[] = {"uniform", "square", "cubic"};
  return names[dimension - 1];
}

/// Points that stand for equal volumes of the region.
template <int Dim>
std::vector<Vec<Dim>> fineLattice(const FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame,
                                  double& edge, double& cellVolume) {
  Lattice<Dim> lattice(plainLattice(Dim), edge);
  lattice.fitTo(frame.domain);
  lattice.startAt(fluid.box.lower);
  cellVolume = lattice.cellVolume();
  edge = std::pow(cellVolume, 1.0 / Dim);
  if (!fluid.region) return latticePoints(lattice, fluid.box);
  return latticePoints(lattice, fluid.box, *fluid.region,
                       {.upper = -surfaceRoundOff * frame.spacing});
}

/// The edge at which the densest place has two cells a particle, along each axis.
template <int Dim>
double fineEdge(const FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame, const CaseNode& node) {
  double edge = frame.spacing, cellVolume = 0;
  const auto coarse = fineLattice(fluid, frame, edge, cellVolume);
  if (coarse.empty())
    at(fluid.settings.node, "region").fail("gets no particle; a smaller spacing is needed");
  const auto density = densitiesAt<Dim>(*fluid.profile, coarse, node);
  const double most = *std::max_element(density.begin(), density.end());
  const double cells = std::pow(2.0, Dim);
  const double volume =
      fluid.lattice.cellVolume() * std::min(1.0, fluid.settings.density / most) / cells;
  constexpr double mostPoints = 4e8;  // of 24 bytes and a number of 8: 13 GB
  const double expected = static_cast<double>(coarse.size()) * cellVolume / volume;
  if (expected > mostPoints)
    node.fail(
        fmt::format("asks for a lattice of {:.3g} points to find places in, more than {:g}; a "
                    "larger spacing or smaller contrast is needed",
                    expected, mostPoints));
  return std::pow(volume, 1.0 / Dim);
}

}  // namespace

template <int Dim>
const FluidFill<Dim>& equalMassPartner(const std::vector<FluidFill<Dim>>& fluids,
                                       const FluidFill<Dim>& fluid) {
  return *std::ranges::find(fluids, fluid.settings.equalMassWith,
                            [](const auto& other) { return other.settings.name; });
}

template <int Dim>
void matchMasses(std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame) {
  for (FluidFill<Dim>& fluid : fluids) {
    if (fluid.settings.equalMassWith.empty()) continue;
    const FluidFill<Dim>& other = equalMassPartner(fluids, fluid);
    Lattice<Dim> plain(fluid.settings.lattice, frame.spacing);
    const double volume =
        other.lattice.cellVolume() * (other.settings.density / fluid.settings.density);
    fluid.lengthScale = std::pow(volume / plain.cellVolume(), 1.0 / Dim);
    fluid.lattice = Lattice<Dim>(fluid.settings.lattice, frame.spacing * fluid.lengthScale);
    fluid.placeLattice();
  }
}

template <int Dim>
void fillWithEqualMasses(FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame, Random random) {
  const CaseNode& node = at(fluid.settings.node, "profile");
  double edge = fineEdge(fluid, frame, node), cellVolume = 0;
  const auto cells = fineLattice(fluid, frame, edge, cellVolume);
  const auto density = densitiesAt<Dim>(*fluid.profile, cells, node);
  const double scale = fluid.isCut || !fluid.region
                           ? 1
                           : fluid.volume.value / (cellVolume * static_cast<double>(cells.size()));
  const double total = scale * cellVolume * std::accumulate(density.begin(), density.end(), 0.0);
  const double wanted = total / (fluid.settings.density * fluid.lattice.cellVolume());
  if (wanted >= 2147483648.0)
    node.fail(fmt::format("asks for {:.3g} particles, more than 2^31; a larger spacing is needed",
                          wanted));
  const double n = std::max(1.0, std::round(wanted));
  fluid.particleMass = total / n;
  fluid.points.clear();
  double passed = 0, next = random.number();  // in particles
  const double roundOff = surfaceRoundOff * frame.spacing;
  const Box<Dim> cell{Vec<Dim>::filled(-edge / 2), Vec<Dim>::filled(edge / 2), {}};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    passed += scale * cellVolume * density[k] / fluid.particleMass;
    while (next < passed && static_cast<double>(fluid.points.size()) < n) {
      Vec<Dim> x = frame.domain.wrap(cells[k] + random.pointIn(cell));
      if (fluid.region && fluid.region->signedDistance(x) > -roundOff) x = cells[k];
      fluid.points.push_back(x);
      next = static_cast<double>(fluid.points.size()) + random.number();
    }
  }
  // Round-off of the sum may leave the last one out.
  while (static_cast<double>(fluid.points.size()) < n) fluid.points.push_back(cells.back());
}

template <int Dim>
std::vector<double> targetVolumes(const FluidFill<Dim>& fluid, std::span<const Vec<Dim>> points,
                                  const Box<Dim>& domain) {
  if (!fluid.settings.spacingFollowsDensity())
    return std::vector<double>(points.size(), fluid.meanVolume());
  auto volumes = densitiesAt<Dim>(*fluid.profile, points, at(fluid.settings.node, "profile"));
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

template const FluidFill<1>& equalMassPartner(const std::vector<FluidFill<1>>&,
                                              const FluidFill<1>&);
template void matchMasses(std::vector<FluidFill<1>>&, const SceneFrame<1>&);
template const FluidFill<2>& equalMassPartner(const std::vector<FluidFill<2>>&,
                                              const FluidFill<2>&);
template void matchMasses(std::vector<FluidFill<2>>&, const SceneFrame<2>&);
template const FluidFill<3>& equalMassPartner(const std::vector<FluidFill<3>>&,
                                              const FluidFill<3>&);
template void matchMasses(std::vector<FluidFill<3>>&, const SceneFrame<3>&);
template void fillWithEqualMasses(FluidFill<1>&, const SceneFrame<1>&, Random);
template void fillWithEqualMasses(FluidFill<2>&, const SceneFrame<2>&, Random);
template void fillWithEqualMasses(FluidFill<3>&, const SceneFrame<3>&, Random);
template std::vector<double> targetVolumes(const FluidFill<1>&, std::span<const Vec<1>>,
                                           const Box<1>&);
template std::vector<double> targetVolumes(const FluidFill<2>&, std::span<const Vec<2>>,
                                           const Box<2>&);
template std::vector<double> targetVolumes(const FluidFill<3>&, std::span<const Vec<3>>,
                                           const Box<3>&);

}  // namespace plenum
