// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/interface.hpp"

#include "particles/particle_file.hpp"
#include "studies/lists.hpp"
#include "studies/maps/grid.hpp"
#include "studies/maps/map_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum::study {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double heavyDensity = 1000;         ///< of two_layers.toml [kg/m^2]
constexpr double weightOfLight = 0.5 * 9.81;  ///< of half a metre, over its density [m^2/s^2]
constexpr const char* collide = "solver.collisions={restitution=0.01,range=0.95}";

const std::vector<GridValue>& methods() {
  static const std::vector<GridValue> all{
      {"sums", {"solver.density=summation"}},
      {"sums+collisions", {"solver.density=summation", collide}},
      {"sums+product", {"solver.density=summation", "solver.momentum=density_product"}},
      {"continuity", {}},
      {"continuity+collisions", {collide}},
      {"continuity+shifting", {"solver.shifting={}"}},
      {"continuity+squared", {"solver.momentum=density_squared"}},
  };
  return all;
}

/// The largest speed of the second half of a run [c]: the first is that of the start's settling.
double speedLater(const RunOutcome& outcome, double soundSpeed) {
  if (outcome.hasFailed()) return nothing;
  const HistoryColumn speeds = historyOf(outcome, "max_speed");
  double largest = 0;
  for (std::size_t k = 0; k < speeds.times.size(); ++k)
    if (speeds.times[k] >= 0.5 * speeds.times.back()) largest = std::max(largest, speeds.values[k]);
  return largest / soundSpeed;
}

GridPlan planOf(const InterfaceOptions& options) {
  GridPlan plan;
  plan.caseFile = writeMapCase(options.common.folder, "two_layers");
  plan.rows.name = "method";
  for (const std::string& name : options.methods)
    plan.rows.values.push_back(*std::ranges::find(methods(), name, &GridValue::text));
  plan.columns.name = "density ratio";
  for (const double ratio : options.ratios) {
    const double light = heavyDensity / ratio;
    plan.columns.values.push_back(
        {fmt::format("{:g}", ratio),
         {fmt::format("fluid[1].density={}", light),
          fmt::format("fluid[0].hydrostatic.pressure_at_surface={}", light * weightOfLight)}});
  }
  if (options.common.quick) plan.settings = {"solver.end_time=0.25", "output.every=0.25"};
  plan.variesSeed = false;
  plan.label = "interface";
  return plan;
}

/// The first ratio at which a method fails, or holes open.
void addRemarks(const Grid& grid, Map& map) {
  const auto& ratios = grid.plan.columns.values;
  for (std::size_t r = 0; r < grid.plan.rows.values.size(); ++r) {
    std::string blows = "none", opens = "none";
    for (std::size_t c = 0; c < ratios.size(); ++c) {
      const RunOutcome& outcome = grid.outcomes[r][c].front();
      if (blows == "none" && outcome.hasFailed()) blows = ratios[c].text;
      // A hole of one point of the grid is 1e-4 of this box; a gap of two spacings all along the
      // interface would be 2e-2.
      if (opens == "none" && outcome.figure("void1") > 1e-3) opens = ratios[c].text;
    }
    map.remarks.push_back(fmt::format("{}: first ratio with a blow-up: {}; with holes: {}",
                                      grid.plan.rows.values[r].text, blows, opens));
  }
}

}  // namespace

std::vector<std::string> interfaceMethods() {
  std::vector<std::string> names;
  for (const GridValue& method : methods()) names.push_back(method.text);
  return names;
}

double interfaceGap(const Scene<2>& scene) {
  const double width = 2 * scene.info.spacing;
  const Box<2>& box = scene.info.domain;
  const auto n = static_cast<std::size_t>(std::max(1.0, std::round(box.extent()[0] / width)));
  std::vector<double> highest(n, -std::numeric_limits<double>::infinity()), lowest(n);
  for (double& y : lowest) y = std::numeric_limits<double>::infinity();
  const auto x = scene.particles[field::position];
  const auto material = scene.particles[field::material];
  for (std::size_t i = 0; i < scene.particles.nFluid(); ++i) {
    const double place = (x[i][0] - box.lower[0]) / box.extent()[0] * static_cast<double>(n);
    const auto k = static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(n) - 1));
    if (material[i] == 0)
      highest[k] = std::max(highest[k], x[i][1]);
    else
      lowest[k] = std::min(lowest[k], x[i][1]);
  }
  std::vector<double> gaps;
  for (std::size_t k = 0; k < n; ++k)
    if (const double gap = lowest[k] - highest[k]; std::isfinite(gap))
      gaps.push_back(gap / scene.info.spacing);
  if (gaps.empty()) return nothing;
  std::ranges::nth_element(gaps, gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2));
  return gaps[gaps.size() / 2];
}

void runInterface(InterfaceOptions options) {
  if (options.methods.empty()) options.methods = interfaceMethods();
  requireWords("--methods", options.methods, interfaceMethods());
  requireNumbers("--ratios", options.ratios, 1, 1e5);
  std::ranges::sort(options.ratios);  // the first that fails is looked for
  const GridPlan plan = planOf(options);
  const double soundSpeed = scalesOf(plan.caseFile, false).soundSpeed;
  const Grid grid = runGrid(plan, options.common);
  const Figure speed = [&](const RunOutcome& run) { return speedLater(run, soundSpeed); };
  const Figure gap = [](const RunOutcome& run) {
    return run.hasFailed() ? nothing
                           : interfaceGap(readParticleFile<2>(run.folder / "run_end.hdf"));
  };
  Map map;
  map.name = "interface";
  map.charts = {{"interface", grid.chart("Speeds of two layers that should rest",
                                         "largest speed/c in the second half of the run", speed)},
                {"interface_gap", grid.chart("Gap between two layers at the end",
                                             "gap [d_ref]; .866 at first", gap)},
                {"interface_void1",
                 grid.chart("Holes in two layers at the end", "void1", lastFigure("void1"))}};
  // Negative gaps, of fluids that mix, would else take all colours.
  map.charts[1].map.lowest = 0;
  map.charts[1].map.highest = 3;
  grid.tabulate({{"max_speed/c", speed},
                 {"gap [d_ref]", gap},
                 {"void1", lastFigure("void1")},
                 {"nn_min", lastFigure("nn_min")},
                 {"f.5", lastFigure("f.5")},
                 {"energy_kinetic [J]", lastFigure("energy_kinetic")}},
                map);
  addRemarks(grid, map);
  publish(map, options.common);
}

}  // namespace plenum::study
