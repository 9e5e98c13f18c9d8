// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/pairing.hpp"

#include "engine/measures.hpp"
#include "particles/errors.hpp"
#include "particles/kernels.hpp"
#include "particles/particle_file.hpp"
#include "studies/lists.hpp"
#include "studies/maps/grid.hpp"
#include "studies/maps/map_cases.hpp"
#include "studies/maps/onset.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace plenum::study {

namespace {

/// The order of the particles of a state; distances in (V/N)^(1/3), as tables of pairing in 3-D
/// have them, where the solver measures in d_ref, which is 2^(1/6) times as long.
SpacingMeasures orderIn3D(const RunOutcome& outcome) {
  const Scene<3> scene = readParticleFile<3>(outcome.folder / "run_end.hdf");
  const double unit =
      std::cbrt(scene.info.domain.volume() / static_cast<double>(scene.particles.nFluid()));
  return measureSpacing<3>(scene.particles, scene.info.domain, unit);
}

Figure figureIn3D(double SpacingMeasures::*member) {
  return [member](const RunOutcome& outcome) {
    return outcome.hasFailed() ? std::nan("") : orderIn3D(outcome).*member;
  };
}

/// Fills in what was not asked for, and refuses what cannot be.
void complete(PairingOptions& options) {
  requireNumbers("--dimension", {static_cast<double>(options.dimension)}, 2, 3);
  requireWords("--start", {options.start}, {"random", "noise"});
  const bool isPlane = options.dimension == 2, isNoise = options.start == "noise";
  const int whole = isPlane && !isNoise ? 8 : 3;  // means of random starts scatter most in 2-D
  options.seeds = seedsOf(options.seeds, options.common, whole, isPlane && !isNoise ? 2 : 1);
  if (options.kernels.empty()) options.kernels = KernelId::names();
  requireWords("--kernels", options.kernels, KernelId::names());
  if (!options.lengths.empty() && !options.neighbours.empty())
    throw InputError("--neighbours and --smoothing-length say the same thing; give one of them");
  if (options.lengths.empty() && options.neighbours.empty()) {
    if (isNoise)
      options.lengths = {1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.75, 1.8, 1.85, 1.9, 2.0};
    else if (isPlane)
      options.lengths = {1.2, 1.5, 2, 2.5, 3};
    else
      options.neighbours = {32, 48, 64, 80, 100, 200, 400};
  }
  // The case file's own range of h/d_ref. In 2-D a support of 12 d_ref would be wider than the box.
  const double highest = isPlane ? 4.5 : 3;
  if (!options.lengths.empty())
    requireNumbers("--smoothing-length", options.lengths, 0.6, highest);
  else
    requireNumbers("--neighbours", options.neighbours, isPlane ? 6 : 12, isPlane ? 290 : 1200);
}

GridAxis columnsOf(const PairingOptions& options) {
  if (!options.lengths.empty())
    return numberAxis("h/d_ref", "solver.smoothing_length", options.lengths);
  GridAxis axis{"neighbours", {}};
  for (const double n : options.neighbours)
    axis.values.push_back(
        {fmt::format("{:g}", n),
         {fmt::format("solver.smoothing_length={}", lengthOfNeighbours(n, options.dimension))}});
  return axis;
}

GridPlan planOf(const PairingOptions& options) {
  const bool isPlane = options.dimension == 2, isNoise = options.start == "noise";
  GridPlan plan;
  plan.caseFile = writeMapCase(options.common.folder, isPlane ? "gas_box" : "pairing_3d");
  plan.rows = wordAxis("kernel", "solver.kernel", options.kernels);
  plan.columns = columnsOf(options);
  plan.seeds = options.seeds.value();
  plan.label = fmt::format("pairing, {}-D", options.dimension);
  plan.settings = {"validate=[]", isPlane ? "output.every=2" : "output.every=10",
                   isPlane ? "output.history_every=0.1" : "output.history_every=1"};
  if (isNoise) {
    plan.settings.push_back(isPlane ? "fluid[0].lattice=hexagonal" : "fluid[0].lattice=hcp");
    plan.settings.push_back("fluid[0].jitter=0.02");
    // Twenty columns and twenty-two rows of a hexagonal lattice that nothing distorts; pairs grow
    // from the noise until t = 4, twice as long as a random start takes.
    if (isPlane)
      plan.settings.insert(plan.settings.end(), {"domain.upper=[1,0.9526279441628825]",
                                                 "solver.end_time=4", "output.every=4"});
  }
  return plan;
}

/// Of rows of f.5 over rising smoothing lengths (or neighbours), where pairing sets in.
void addOnsets(const Grid& grid, const Figure& paired, Map& map) {
  std::vector<double> places;
  for (const GridValue& column : grid.plan.columns.values) places.push_back(std::stod(column.text));
  for (std::size_t r = 0; r < grid.plan.rows.values.size(); ++r) {
    std::vector<double> shares;
    for (std::size_t c = 0; c < places.size(); ++c) shares.push_back(grid.at(r, c, paired));
    map.remarks.push_back(fmt::format("{}: {}", grid.plan.rows.values[r].text,
                                      onsetSentence(places, shares, grid.plan.columns.name)));
  }
}

}  // namespace

double lengthOfNeighbours(double neighbours, int dimension) {
  using std::numbers::pi;
  if (dimension == 2)  // a particle has the area sqrt(3)/2 d_ref^2
    return std::sqrt(neighbours * std::sqrt(3.0) / (8 * pi));
  // and in hcp the volume d_ref^3/sqrt(2)
  return std::cbrt(3 * neighbours / (32 * pi * std::numbers::sqrt2));
}

void runPairing(PairingOptions options) {
  complete(options);
  const bool isPlane = options.dimension == 2;
  const Grid grid = runGrid(planOf(options), options.common);
  const Figure paired = isPlane ? lastFigure("f.5") : figureIn3D(&SpacingMeasures::below05);
  const Figure least = isPlane ? lastFigure("nn_min") : figureIn3D(&SpacingMeasures::minNearest);
  Map map;
  map.name =
      fmt::format("pairing_{}d{}{}", options.dimension, options.start == "noise" ? "_noise" : "",
                  options.neighbours.empty() ? "" : "_neighbours");
  const std::string from =
      options.start == "noise" ? "from a lattice with noise" : "from a random start";
  const std::string unit = isPlane ? "d_ref" : "(V/N)^(1/3)";
  std::vector<std::pair<std::string, Figure>> figures{{"f.5", paired}, {"nn_min", least}};
  map.charts.push_back(
      {map.name, grid.chart(fmt::format("Paired particles {}, {}-D", from, options.dimension),
                            "f.5: share nearer than .5 " + unit, paired)});
  map.charts.push_back(
      {map.name + "_nn", grid.chart(fmt::format("Least distance {}, {}-D", from, options.dimension),
                                    "least nn [" + unit + "], mean of seeds", least)});
  if (isPlane) {
    figures.emplace_back("psi6", lastFigure("psi6"));
    map.charts.push_back({map.name + "_psi6", grid.chart("Hexagonal order " + from, "mean |psi_6|",
                                                         lastFigure("psi6"))});
  }
  for (MapChart& chart : map.charts) {
    chart.map.lowest = 0;
    chart.map.highest = 1;
  }
  if (isPlane)
    for (const auto& [column, columnUnit] :
         {std::pair{"f.5", ""}, {"nn_min", "d_ref"}, {"psi6", ""}})
      map.lines.push_back({fmt::format("{}_time_{}", map.name, column),
                           grid.overTime("Gas box " + from, column, columnUnit)});
  grid.tabulate(figures, map);
  addOnsets(grid, paired, map);
  publish(map, options.common);
}

}  // namespace plenum::study
