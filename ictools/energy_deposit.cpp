// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/energy_deposit.hpp"

#include "particles/ideal_gas.hpp"
#include "particles/kernels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace plenum {

template <int Dim>
void depositEnergy(const FluidSettings& fluid, const SceneFrame<Dim>& frame,
                   std::span<const Vec<Dim>> positions, std::span<const double> masses,
                   const StateArrays& states) {
  const EnergyDepositSettings& deposit = *fluid.energyDeposit;
  Vec<Dim> point;
  for (int a = 0; a < Dim; ++a) point[a] = deposit.point[static_cast<std::size_t>(a)];
  if (!frame.domain.contains(point))
    at(at(fluid.node, "energy_deposit"), "point")
        .fail("lies outside of the domain; move it inside");
  const kernel::Any kernel{KernelId::named(frame.solver.kernel)};
  const auto distance = [&](std::size_t k) {
    return norm(frame.domain.nearestImage(positions[k] - point));
  };
  std::vector<std::pair<std::size_t, double>> weights;  // of the few particles in reach
  double sum = 0, nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const double r = distance(k);
    nearest = std::min(nearest, r);
    const double weight = r < deposit.radius ? kernel.f(2 * r / deposit.radius) : 0;
    if (!(weight > 0)) continue;
    weights.emplace_back(k, weight);
    sum += masses[k] * weight;
  }
  if (weights.empty())
    at(at(fluid.node, "energy_deposit"), "radius")
        .fail(fmt::format("no particle of fluid \"{}\" is in reach of the point, the nearest is "
                          "{:g} m away; make the radius larger than that, or move the point",
                          fluid.name, nearest));
  for (const auto& [k, weight] : weights) {
    states.internalEnergy[k] += deposit.energy * weight / sum;
    states.pressure[k] =
        pressureOfEnergy(states.internalEnergy[k], states.density[k], frame.solver.adiabaticIndex);
  }
}

template void depositEnergy(const FluidSettings&, const SceneFrame<1>&, std::span<const Vec<1>>,
                            std::span<const double>, const StateArrays&);
template void depositEnergy(const FluidSettings&, const SceneFrame<2>&, std::span<const Vec<2>>,
                            std::span<const double>, const StateArrays&);
template void depositEnergy(const FluidSettings&, const SceneFrame<3>&, std::span<const Vec<3>>,
                            std::span<const double>, const StateArrays&);

}  // namespace plenum
