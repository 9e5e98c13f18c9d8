// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/tension.hpp"

#include "particles/kernels.hpp"
#include "studies/lists.hpp"
#include "studies/maps/grid.hpp"
#include "studies/maps/map_cases.hpp"
#include "studies/maps/onset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace plenum::study {

namespace {

void requireUsable(const TensionOptions& options) {
  requireWords("--kernel", {options.kernel}, KernelId::names());
  requireNumbers("--pressures", options.pressures, -1, 1);
  requireNumbers("--smoothing-length", options.lengths, 0.6, 4.5);  // 4.5: what fits into the box
}

GridPlan planOf(const TensionOptions& options) {
  GridPlan plan;
  plan.seeds = seedsOf(options.seeds, options.common, 3, 1);
  plan.caseFile = writeMapCase(options.common.folder, "gas_box");
  const Scales scales = scalesOf(plan.caseFile, false);
  std::vector<double> pressures = options.pressures;
  std::ranges::sort(pressures, std::greater());
  plan.rows.name = "p0/(rho c^2)";
  for (const double p : pressures)  // rho = 1 in the gas box
    plan.rows.values.push_back({fmt::format("{:g}", p),
                                {fmt::format("solver.background_pressure={}",
                                             p * scales.soundSpeed * scales.soundSpeed)}});
  plan.columns = numberAxis("h/d_ref", "solver.smoothing_length", options.lengths);
  plan.settings = {"validate=[]",
                   "output.every=2",
                   "solver.kernel=" + options.kernel,
                   "domain.upper=[1,0.9526279441628825]",  // a hexagonal lattice undistorted
                   "fluid[0].lattice=hexagonal",
                   "fluid[0].jitter=0.02"};
  plan.label = "tension";
  return plan;
}

/// At each smoothing length the highest pressure at which particles pair. A lattice can be gone
/// before (psi6).
void addRemarks(const Grid& grid, Map& map) {
  const GridPlan& plan = grid.plan;
  for (std::size_t c = 0; c < plan.columns.values.size(); ++c) {
    std::optional<std::size_t> first;  // row: pressures fall
    for (std::size_t r = 0; r < plan.rows.values.size() && !first; ++r) {
      const double share = grid.at(r, c, lastFigure("f.5"));
      if (std::isnan(share) || share > pairedShare) first = r;
    }
    std::string remark = fmt::format("h/d_ref {}: ", plan.columns.values[c].text);
    if (!first || *first > 0)
      remark += fmt::format("no pairs down to {} {}", plan.rows.name,
                            plan.rows.values[first.value_or(plan.rows.values.size()) - 1].text);
    if (first && *first > 0) remark += ", ";
    if (first) remark += fmt::format("pairs from {}", plan.rows.values[*first].text);
    map.remarks.push_back(remark);
  }
}

}  // namespace

void runTension(const TensionOptions& options) {
  requireUsable(options);
  const Grid grid = runGrid(planOf(options), options.common);
  Map map;
  map.name = "tension";
  const std::string with = ", " + options.kernel;
  for (const auto& [suffix, title, label, figure] :
       {std::tuple{"", "Clumped particles under tension", "f.5: share nearer than .5 d_ref", "f.5"},
        std::tuple{"_nn", "Least distance under tension", "least nn [d_ref]", "nn_min"},
        std::tuple{"_psi6", "Hexagonal order under tension", "mean |psi_6|", "psi6"},
        std::tuple{"_void1", "Holes under tension", "void1: share of the box in holes", "void1"}}) {
    map.charts.push_back({map.name + suffix, grid.chart(title + with, label, lastFigure(figure))});
    map.charts.back().map.lowest = 0;
    map.charts.back().map.highest = 1;
  }
  grid.tabulate({{"f.5", lastFigure("f.5")},
                 {"nn_min", lastFigure("nn_min")},
                 {"psi6", lastFigure("psi6")},
                 {"void1", lastFigure("void1")},
                 {"max_speed [m/s]", lastFigure("max_speed")}},
                map);
  addRemarks(grid, map);
  publish(map, options.common);
}

}  // namespace plenum::study
