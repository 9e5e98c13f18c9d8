// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/equal_masses.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

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

template const FluidFill<1>& equalMassPartner(const std::vector<FluidFill<1>>&,
                                              const FluidFill<1>&);
template void matchMasses(std::vector<FluidFill<1>>&, const SceneFrame<1>&);
template const FluidFill<2>& equalMassPartner(const std::vector<FluidFill<2>>&,
                                              const FluidFill<2>&);
template void matchMasses(std::vector<FluidFill<2>>&, const SceneFrame<2>&);
template const FluidFill<3>& equalMassPartner(const std::vector<FluidFill<3>>&,
                                              const FluidFill<3>&);
template void matchMasses(std::vector<FluidFill<3>>&, const SceneFrame<3>&);

}  // namespace plenum
