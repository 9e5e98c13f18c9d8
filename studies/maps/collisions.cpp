// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/collisions.hpp"

#include "particles/kernels.hpp"
#include "studies/lists.hpp"
#include "studies/maps/grid.hpp"
#include "studies/maps/map_cases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace plenum::study {

namespace {

/// The range at which the least distance is largest, for each restitution, of those at which no
/// seed failed.
void addRemarks(const Grid& grid, Map& map) {
  for (std::size_t r = 0; r < grid.plan.rows.values.size(); ++r) {
    std::size_t best = 0;
    const auto nearestAt = [&](std::size_t c) {
      return grid.hasFailures(r, c) ? std::numeric_limits<double>::quiet_NaN()
                                    : grid.at(r, c, lastFigure("nn_min"));
    };
    for (std::size_t c = 0; c < grid.plan.columns.values.size(); ++c)
      if (std::isnan(nearestAt(best)) || nearestAt(c) > nearestAt(best)) best = c;
    if (std::isnan(nearestAt(best))) continue;  // all failed
    map.remarks.push_back(fmt::format(
        "C_R {}: particles stay furthest apart at delta_c = {} d_ref "
        "(least nn {:.2f})",
        grid.plan.rows.values[r].text, grid.plan.columns.values[best].text, nearestAt(best)));
  }
}

}  // namespace

void runCollisions(const CollisionOptions& options) {
  requireWords("--kernel", {options.kernel}, KernelId::names());
  requireNumbers("--range", options.ranges, 0.1, 2);
  requireNumbers("--restitution", options.restitutions, 0, 1);
  GridPlan plan;
  plan.seeds = seedsOf(options.seeds, options.common, 8, 2);
  plan.caseFile = writeMapCase(options.common.folder, "gas_box");
  plan.rows = numberAxis("C_R", "solver.collisions.restitution", options.restitutions);
  plan.columns = numberAxis("delta_c/d_ref", "solver.collisions.range", options.ranges);
  plan.settings = {"validate=[]", "output.every=2", "solver.kernel=" + options.kernel};
  plan.label = "collisions";
  const Grid grid = runGrid(plan, options.common);
  Map map;
  map.name = "collisions";
  const std::string with = " with collisions, " + options.kernel;
  map.charts = {
      {"collisions", grid.chart("Least distance" + with, "least nn [d_ref], mean of seeds",
                                lastFigure("nn_min"))},
      {"collisions_psi6", grid.chart("Hexagonal order" + with, "mean |psi_6|", lastFigure("psi6"))},
      {"collisions_speed",
       grid.chart("Largest speed" + with, "largest speed [m/s]", lastFigure("max_speed"))}};
  for (MapChart& chart : map.charts) chart.map.lowest = 0;
  for (const std::size_t k : {0u, 1u}) map.charts[k].map.highest = 1;
  grid.tabulate({{"nn_min", lastFigure("nn_min")},
                 {"f.5", lastFigure("f.5")},
                 {"psi6", lastFigure("psi6")},
                 {"max_speed [m/s]", lastFigure("max_speed")}},
                map);
  addRemarks(grid, map);
  publish(map, options.common);
}

}  // namespace plenum::study
