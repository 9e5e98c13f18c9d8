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

/// Rows go by what differs between them: the kernel, the background pressure, or both.
class RowNames {
 public:
  explicit RowNames(const ModeMap& map)
      : first_(map.rows.front()),
        isOneKernel_(std::ranges::all_of(
            map.rows, [&](const ModeRow& row) { return row.kernel == first_.kernel; })),
        isOnePressure_(std::ranges::all_of(map.rows, [&](const ModeRow& row) {
          return row.backgroundPressure == first_.backgroundPressure;
        })) {}

  std::string of(const ModeRow& row) const {
    if (isOnePressure_) return std::string(row.kernel.name());
    const std::string pressure = fmt::format("{:g}", row.backgroundPressure);
    return isOneKernel_ ? pressure : fmt::format("{} {}", row.kernel.name(), pressure);
  }

  std::string title() const { return isOnePressure_ ? "" : "p0/(rho0 c^2)"; }

  /// What all rows have in common, for the map's title.
  std::string shared() const {
    if (isOnePressure_) return fmt::format(", p0 = {:g} rho0 c^2", first_.backgroundPressure);
    return isOneKernel_ ? fmt::format(", {}", first_.kernel.name()) : "";
  }

 private:
  const ModeRow& first_;
  bool isOneKernel_, isOnePressure_;
};

}  // namespace

ModeMap computeModes(const std::string& lattice, const std::vector<double>& backgroundPressures,
                     const std::vector<std::string>& kernels,
                     const std::vector<double>& smoothingLengths) {
  const bool isPlane = std::ranges::count(latticeNames(2), lattice) > 0;
  ModeMap map{lattice, smoothingLengths, {}};
  for (const std::string& kernel : kernels)
    for (const double pressure : backgroundPressures) {
      ModeRow& row = map.rows.emplace_back(ModeRow{KernelId::named(kernel), pressure, {}});
      for (const double h : smoothingLengths) {
        const LatticeState state{lattice, row.kernel, h, pressure};
        row.cells.push_back(isPlane ? cellOf<2>(state) : cellOf<3>(state));
      }
    }
  return map;
}

HeatMap heatMapOf(const ModeMap& map) {
  const RowNames names(map);
  HeatMap heat{fmt::format("Fastest growing wave of a {} lattice{}", map.lattice, names.shared()),
               names.title(),
               "h/d_ref",
               "growth rate [c/d_ref]",
               {},
               {},
               {},
               {},
               0,
               {}};
  for (const double h : map.smoothingLengths) heat.columns.push_back(fmt::format("{:g}", h));
  for (const ModeRow& row : map.rows) {
    heat.rows.push_back(names.of(row));
    heat.values.emplace_back();
    heat.texts.emplace_back();
    for (const ModeCell& cell : row.cells) {
      const bool isStable = cell.omegaSquared > -rounding;
      const double growth = isStable ? 0 : std::sqrt(-cell.omegaSquared);
      heat.values.back().push_back(growth);
      heat.texts.back().push_back(isStable ? "" : fmt::format("{:.2g}", growth));
    }
  }
  return heat;
}

std::string tableOf(const ModeMap& map) {
  const RowNames names(map);
  std::string text = fmt::format("{:<26}", "lowest omega^2 at h");
  for (const double h : map.smoothingLengths) text += fmt::format("{:>10g}", h);
  text += "\n";
  for (const ModeRow& row : map.rows) {
    text += fmt::format("{:<26}", names.of(row));
    for (const ModeCell& cell : row.cells)
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
  for (const ModeRow& row : map.rows)
    for (std::size_t s = 0; s < map.smoothingLengths.size(); ++s) {
      const ModeCell& cell = row.cells[s];
      text += fmt::format("{},{:g},{},{:g},{:.6g},{:.4f},{:.3f}\n", map.lattice,
                          row.backgroundPressure, row.kernel.name(), map.smoothingLengths[s],
                          cell.omegaSquared, cell.wavelength, cell.longitudinal);
    }
  return text;
}

}  // namespace plenum::study
