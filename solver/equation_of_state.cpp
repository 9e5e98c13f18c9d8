// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/equation_of_state.hpp"

namespace plenum {

void MaterialTable::pressures(std::span<const double> densities,
                              std::span<const std::int32_t> materials,
                              std::span<double> pressures) const {
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(pressures.size()); ++k) {
    const auto i = static_cast<std::size_t>(k);
    pressures[i] = of(materials, i).pressure(densities[i]);
  }
}

}  // namespace plenum
