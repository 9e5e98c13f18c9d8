// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/estimate.hpp"

#include "ictools/cells.hpp"
#include "particles/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plenum {

namespace {

// Largest resident sets less the programs' own, over the particles: plenum-ic made a tank of 1.7e6
// particles in 188 bytes each and of 4.7e6 in 163; plenum-sph ran one of 2.5e5 in 262.
constexpr double programItself = 25e6;  // bytes
constexpr double generateBytesAParticle = 190;
// Of fluids whose spacing varies: the cells that their places are found in. A refined ball of 9.9e5
// particles took 627 bytes each, one of 2.9e6 640.
constexpr double cellBytesAParticle = 640;
constexpr double runBytesAParticle = 280;
constexpr double secondsAnInteraction = 4e-9;  // docs/benchmarks.md: 3.8 to 4.2 ns

}  // namespace

template <int Dim>
double expectedFluid(const std::vector<FluidFill<Dim>>& fluids) {
  double n = 0;
  for (const auto& fluid : fluids) n += fluid.expected;
  return n;
}

template <int Dim>
double expectedWalls(const std::vector<WallFill<Dim>>& walls, const Box<Dim>& box) {
  double n = 0;
  for (const auto& wall : walls) {
    const auto depths = [&](std::span<const Vec<Dim>> points, std::span<double> depth) {
      wall.solid.geometry->signedDistance(points, depth);
      for (double& d : depth) d = wall.solid.depth(d);
    };
    CellSizes<Dim> sizes;  // fine at the layers only
    sizes.most = 20000;    // of which a third or more are in the layers: to some percent
    sizes.coarsest = std::pow(box.volume() / 1000, 1.0 / Dim);
    sizes.at = [&](std::span<const Vec<Dim>> centers, std::span<double> edges) {
      depths(centers, edges);
      for (double& edge : edges) {
        const double away = std::max(-edge, edge - wall.thickness);
        edge = std::max(wall.thickness / 4, 2 / std::sqrt(Dim) * away);
      }
    };
    const Cells<Dim> cells = cellsOf<Dim>(nullptr, box, sizes, 0);
    std::vector<double> depth(cells.centers.size());
    depths(cells.centers, depth);
    for (std::size_t k = 0; k < depth.size(); ++k)
      if (depth[k] >= 0 && depth[k] <= wall.thickness)
        n += cells.volumes[k] / wall.lattice.cellVolume();
  }
  return n;
}

template <int Dim>
double memoryToGenerate(const std::vector<FluidFill<Dim>>& fluids, double nWalls) {
  double bytes = programItself + generateBytesAParticle * nWalls;
  for (const auto& fluid : fluids)
    bytes += fluid.expected * (fluid.spacingVaries() ? cellBytesAParticle : generateBytesAParticle);
  return bytes;
}

template <int Dim>
Estimate estimateOf(double nFluid, double nWalls, bool isCounted, const FluidFill<Dim>& first,
                    const SceneFrame<Dim>& frame) {
  constexpr double unitBall[] = {2, std::numbers::pi, 4 * std::numbers::pi / 3};
  Estimate estimate{nFluid, nWalls, isCounted};
  const double volume = first.lattice.cellVolume();
  const double h = frame.solver.lengthsFollow() ? frame.lengthOfVolume(volume)
                                                : frame.smoothingLength() * first.lengthScale;
  estimate.neighbours = unitBall[Dim - 1] * std::pow(2 * h, Dim) / volume - 1;
  const double n = nFluid + nWalls;
  estimate.runMemory = programItself + runBytesAParticle * n;
  const double nInteracting = frame.solver.wallsEvolve() ? n : nFluid;
  estimate.stepTime = secondsAnInteraction * nInteracting * estimate.neighbours;
  return estimate;
}

template <int Dim>
void checkMemory(const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame) {
  const double expected = expectedFluid(fluids);
  const double needed = memoryToGenerate(fluids, 0);
  const double available = availableMemory().value_or(needed);
  if (needed <= available) return;
  const auto largest = std::ranges::max_element(fluids, {}, &FluidFill<Dim>::expected);
  at(largest->settings.node, "region")
      .fail(fmt::format("the fluids would hold {:.3g} particles and need {} of memory, {} are "
                        "available; a spacing of at least {:.3g} m is needed (are the lengths in "
                        "metres?){}",
                        expected, printedBytes(needed), printedBytes(available),
                        frame.spacing * std::pow(needed / available, 1.0 / Dim),
                        largest->resolution ? ", or a larger one in [[refine]]" : ""));
}

std::string describe(const Estimate& estimate) {
  const char* about = estimate.isCounted ? "" : "about ";
  const auto number = [&](double n) {
    return estimate.isCounted ? fmt::format("{:.0f}", n) : fmt::format("{:.3g}", n);
  };
  std::string text = fmt::format(
      "  particles  {}{} fluid, {}{} wall; {:.0f} neighbours in the "
      "kernel's support\n",
      about, number(estimate.nFluid), about, number(estimate.nWalls), estimate.neighbours);
  text += fmt::format("  memory     about {} to generate, {} to run\n",
                      printedBytes(estimate.generateMemory), printedBytes(estimate.runMemory));
  text += fmt::format(
      "  a step     about {:.2g} s with one thread (4 ns an interaction, "
      "docs/benchmarks.md)\n",
      estimate.stepTime);
  return text;
}

template double expectedFluid(const std::vector<FluidFill<1>>&);
template double expectedWalls(const std::vector<WallFill<1>>&, const Box<1>&);
template double memoryToGenerate(const std::vector<FluidFill<1>>&, double);
template Estimate estimateOf(double, double, bool, const FluidFill<1>&, const SceneFrame<1>&);
template void checkMemory(const std::vector<FluidFill<1>>&, const SceneFrame<1>&);
template double expectedFluid(const std::vector<FluidFill<2>>&);
template double expectedWalls(const std::vector<WallFill<2>>&, const Box<2>&);
template double memoryToGenerate(const std::vector<FluidFill<2>>&, double);
template Estimate estimateOf(double, double, bool, const FluidFill<2>&, const SceneFrame<2>&);
template void checkMemory(const std::vector<FluidFill<2>>&, const SceneFrame<2>&);
template double expectedFluid(const std::vector<FluidFill<3>>&);
template double expectedWalls(const std::vector<WallFill<3>>&, const Box<3>&);
template double memoryToGenerate(const std::vector<FluidFill<3>>&, double);
template Estimate estimateOf(double, double, bool, const FluidFill<3>&, const SceneFrame<3>&);
template void checkMemory(const std::vector<FluidFill<3>>&, const SceneFrame<3>&);

}  // namespace plenum
