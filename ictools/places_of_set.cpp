// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/places_of_set.hpp"

#include "ictools/number_density.hpp"
#include "ictools/positions.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plenum {

namespace {

/// Fluid particles in the order of their ids.
template <int Dim>
std::vector<std::size_t> orderById(const ParticleSet<Dim>& particles) {
  std::vector<std::size_t> order(particles.nFluid());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return particles[field::id][i]; });
  return order;
}

template <int Dim>
void checkFluids(const std::vector<FluidFill<Dim>>& fluids, const SceneInfo<Dim>& info) {
  const bool same = std::ranges::equal(
      fluids, info.materials,
      [](const auto& fluid, const auto& m) { return fluid.settings.name == m.name; });
  if (!same)
    throw InputError(fmt::format(
        "{}: the file has {} fluids, the case that it carries has {} or of other names; "
        "leave the fluids as the set was made with",
        info.caseName, info.materials.size(), fluids.size()));
}

}  // namespace

template <int Dim>
void takePlaces(std::vector<FluidFill<Dim>>& fluids, const Scene<Dim>& scene,
                const SceneFrame<Dim>& frame) {
  checkFluids(fluids, scene.info);
  for (FluidFill<Dim>& fluid : fluids) fluid.points.clear();
  const bool hasMaterials = scene.particles.has(field::material);  // a run of one fluid needs none
  for (const std::size_t i : orderById(scene.particles)) {
    const auto m = hasMaterials ? static_cast<std::size_t>(scene.particles[field::material][i])
                                : std::size_t{0};
    fluids[m].points.push_back(frame.domain.wrap(scene.particles[field::position][i]));
  }
  for (std::size_t m = 0; m < fluids.size(); ++m) {
    FluidFill<Dim>& fluid = fluids[m];
    if (fluid.points.empty())
      fluid.settings.node.fail(
          fmt::format("no particle of fluid \"{}\" is in the file; make the "
                      "set anew with generate",
                      fluid.settings.name));
    fluid.isPlaced = true;
    fluid.settings.jitter = 0;  // the set has it
    if (fluid.spacingVaries()) setShares(fluid, frame);
    checkInside(fluid, fluid.points, frame, fluid.settings.node);
  }
}

template void takePlaces(std::vector<FluidFill<1>>&, const Scene<1>&, const SceneFrame<1>&);
template void takePlaces(std::vector<FluidFill<2>>&, const Scene<2>&, const SceneFrame<2>&);
template void takePlaces(std::vector<FluidFill<3>>&, const Scene<3>&, const SceneFrame<3>&);

}  // namespace plenum
