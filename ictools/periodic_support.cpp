// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/periodic_support.hpp"

#include <fmt/format.h>

namespace plenum {

template <int Dim>
void checkSupports(const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame) {
  for (const FluidFill<Dim>& fluid : fluids) {
    const double support = frame.support() * fluid.lengthScale;
    for (int a = 0; a < Dim; ++a) {
      if (!frame.domain.isPeriodic(a)) continue;
      const double length = frame.domain.upper[a] - frame.domain.lower[a];
      if (length >= 2 * support * (1 - 1e-9)) continue;  // rounding; the engine is as strict
      at(fluid.settings.node, "equal_mass_with")
          .fail(fmt::format(
              "periodic axis {} is {:g} m long, less than twice the support of {:g} m that the "
              "particles of fluid \"{}\" have; make the domain at least {:g} m there, or spacing "
              "or solver.smoothing_length smaller",
              "xyz"[a], length, support, fluid.settings.name, 2 * support));
    }
  }
}

template void checkSupports(const std::vector<FluidFill<1>>&, const SceneFrame<1>&);
template void checkSupports(const std::vector<FluidFill<2>>&, const SceneFrame<2>&);
template void checkSupports(const std::vector<FluidFill<3>>&, const SceneFrame<3>&);

}  // namespace plenum
