// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/equation_of_state.hpp"

#include "particles/parallel.hpp"

namespace plenum {

void MaterialTable::pressures(std::span<const double> densities,
                              std::span<const std::int32_t> materials,
                              std::span<double> pressures) const {
  forEachIndex(pressures.size(),
               [&](std::size_t i) { pressures[i] = of(materials, i).pressure(densities[i]); });
}

}  // namespace plenum
