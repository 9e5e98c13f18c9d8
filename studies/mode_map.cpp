// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/mode_map.hpp"

#include "ictools/lattice.hpp"
#include "studies/lattice_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plenum::study {

namespace {

template <int Dim>
ModeCell cellOf(const LatticeState& state) {
  const Mode<Dim> mode = LatticeModes<Dim>(state).lowest();
  return {mode.omegaSquared, mode.wavelength(), mode.longitudinal};
}

/// Waves that neither grow nor swing, to rounding.
constexpr double rounding = 1e-9;

}  // namespace

ModeMap computeModes(const std::string& lattice, double backgroundPressure,
                     const std::vector<std::string>& kernels,
                     const std::vector<double>& smoothingLengths) {
  const bool isPlane = std::ranges::count(latticeNames(2), lattice) > 0;
  ModeMap map{lattice, backgroundPressure, kernels, smoothingLengths, {}};
  for (const std::string& kernel : kernels) {
    map.cells.emplace_back();
    for (const double h : smoothingLengths) {
      const LatticeState state{lattice, KernelId::named(kernel), h, backgroundPressure};
      map.cells.back().push_back(isPlane ? cellOf<2>(state) : cellOf<3>(state));
    }
  }
  return map;
}

HeatMap heatMapOf(const ModeMap& map) {
  HeatMap heat{fmt::format("Fastest growing wave of a {} lattice, p0 = {:g} rho c^2", map.lattice,
                           map.backgroundPressure),
               "",
               "h/d_ref",
               "growth rate [c/d_ref]",
               map.kernels,
               {},
               {},
               {},
               0,
               {}};
  for (const double h : map.smoothingLengths) heat.columns.push_back(fmt::format("{:g}", h));
  for (const auto& row : map.cells) {
    heat.values.emplace_back();
    heat.texts.emplace_back();
    for (const ModeCell& cell : row) {
      const bool isStable = cell.omegaSquared > -rounding;
      const double growth = isStable ? 0 : std::sqrt(-cell.omegaSquared);
      heat.values.back().push_back(growth);
      heat.texts.back().push_back(isStable ? "" : fmt::format("{:.2g}", growth));
    }
  }
  return heat;
}

std::string tableOf(const ModeMap& map) {
  std::string text = fmt::format("{:<20}", "lowest omega^2 at h");
  for (const double h : map.smoothingLengths) text += fmt::format("{:>10g}", h);
  text += "\n";
  for (std::size_t k = 0; k < map.kernels.size(); ++k) {
    text += fmt::format("{:<20}", map.kernels[k]);
    for (const ModeCell& cell : map.cells[k])
      text += cell.omegaSquared > -rounding ? fmt::format("{:>10}", "stable")
                                            : fmt::format("{:>10.2e}", cell.omegaSquared);
    text += "\n";
  }
  return text;
}

std::string csvOf(const ModeMap& map) {
  std::string text =
      "lattice,p0 [rho0 c^2],kernel,h/d_ref,lowest omega^2 [c^2/d_ref^2],wavelength "
      "[d_ref],longitudinal\n";
  for (std::size_t k = 0; k < map.kernels.size(); ++k)
    for (std::size_t s = 0; s < map.smoothingLengths.size(); ++s) {
      const ModeCell& cell = map.cells[k][s];
      text += fmt::format("{},{:g},{},{:g},{:.6g},{:.4f},{:.3f}\n", map.lattice,
                          map.backgroundPressure, map.kernels[k], map.smoothingLengths[s],
                          cell.omegaSquared, cell.wavelength, cell.longitudinal);
    }
  return text;
}

}  // namespace plenum::study
