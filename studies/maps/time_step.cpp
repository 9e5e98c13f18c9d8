// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/time_step.hpp"

#include "studies/lists.hpp"
#include "studies/maps/bisection.hpp"
#include "studies/maps/map_cases.hpp"
#include "studies/run_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum::study {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
/// Courant numbers c dt/h between which is searched. plenum-sph refuses steps above 2 h/c.
constexpr double lowest = 0.03, highest = 2;

/// A case, and what is too fast in it. Where a step is too large speeds grow by a factor a step, to
/// the speed of sound and beyond, so limits need not be sharp.
struct TimeStepScene {
  const char* name;
  const char* caseName;
  double endTime;     ///< [s]
  double speedLimit;  ///< [c]; the run ends, as a failure, when a particle is faster
  const char* why;    ///< this limit
  std::vector<std::string> settings;
};

const std::vector<TimeStepScene>& scenes() {
  static const std::vector<TimeStepScene> all{
      {"box",
       "gas_box",
       2,
       0.1,
       "its noise of 2 % moves at .02 c",
       {"domain.upper=[1,0.9526279441628825]", "fluid[0].lattice=hexagonal",
        "fluid[0].jitter=0.02"}},
      {"tank", "hydrostatic_tank", 1, 0.1, "it is at rest but for .002 c", {}},
      {"shaft", "rotating_shaft", 0.5, 1, "it turns with .42 c", {}},
      {"dam", "dam_break_multiphase", 0.2, 5, "air beside the water has .6 c for moments", {}},
  };
  return all;
}

struct Cell {
  const TimeStepScene* scene = nullptr;
  double alpha = 0;
  std::filesystem::path caseFile;
  Scales scales;
  Bisection search{lowest, highest, 1.03};
  double blowUpTime = nothing;  ///< at the smallest step that went wrong [s]
};

/// The step nearest below `courant` of which a whole number fills the run [s].
double stepOf(const Cell& cell, double courant) {
  const double asked = courant * cell.scales.smoothingLength / cell.scales.soundSpeed;
  return cell.scene->endTime / std::ceil(cell.scene->endTime / asked);
}

RunRequest requestOf(const Cell& cell, double dt, bool quick) {
  RunRequest request{cell.caseFile, cell.scene->settings, 1, quick};
  for (const std::string& setting :
       {std::string("validate=[]"), std::string("measures.order=false"),
        fmt::format("solver.time_step={}", dt),
        fmt::format("solver.end_time={}", cell.scene->endTime),
        // Steps are cut to end where a file or a row of the history is due: at the end only.
        fmt::format("output.every={}", cell.scene->endTime),
        fmt::format("output.history_every={}", cell.scene->endTime),
        fmt::format("solver.speed_limit={}", cell.scene->speedLimit),
        fmt::format("solver.viscosity={{monaghan={{alpha={}}}}}", cell.alpha)})
    request.settings.push_back(setting);
  return request;
}

std::vector<Cell> cellsOf(const TimeStepOptions& options) {
  std::vector<Cell> cells;
  for (const std::string& name : options.scenes) {
    const auto scene = std::ranges::find(scenes(), name, &TimeStepScene::name);
    const auto caseFile = writeMapCase(options.common.folder, scene->caseName);
    for (const double alpha : options.alphas)
      cells.push_back({&*scene,
                       alpha,
                       caseFile,
                       scalesOf(caseFile, options.common.quick),
                       {lowest, highest, options.common.quick ? 1.1 : 1.03},
                       nothing});
  }
  return cells;
}

/// Runs one step of all searches that are not over; false if there was none. The runs go into the
/// map's table.
bool searchOnce(std::vector<Cell>& cells, RunStore& store, const MapOptions& options, int round,
                Map& map) {
  std::vector<std::pair<Cell*, double>> asked;
  std::vector<RunRequest> requests;
  for (Cell& cell : cells)
    if (const auto courant = cell.search.next()) {
      asked.emplace_back(&cell, stepOf(cell, *courant));
      requests.push_back(requestOf(cell, asked.back().second, options.quick));
    }
  if (requests.empty()) return false;
  const auto outcomes =
      store.run(requests, options.jobs, fmt::format("time steps, round {}", round));
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    auto& [cell, dt] = asked[k];
    const double courant = cell->scales.soundSpeed * dt / cell->scales.smoothingLength;
    cell->search.record(courant, !outcomes[k].hasFailed());
    if (outcomes[k].hasFailed()) cell->blowUpTime = outcomes[k].failureTime.value_or(nothing);
    map.rows.push_back(
        {cell->scene->name, fmt::format("{:g}", cell->alpha), fmt::format("{:.5g}", courant),
         fmt::format("{:.6g}", dt), outcomes[k].hasFailed() ? "no" : "yes",
         outcomes[k].failureTime ? fmt::format("{:.6g}", *outcomes[k].failureTime) : "",
         outcomes[k].failure});
  }
  return true;
}

std::string limitText(const Bisection& search) {
  if (!search.good()) return fmt::format("< {:g}", lowest);
  const int digits = *search.good() < 0.2 ? 3 : 2;
  if (!search.bad()) return fmt::format("{:.{}f}, all", *search.good(), digits);
  return fmt::format("{0:.{2}f}-{1:.{2}f}", *search.good(), *search.bad(), digits);
}

/// A chart with a row for each scene and a column for each alpha.
MapChart chartOf(const TimeStepOptions& options, const std::vector<Cell>& cells, const char* name,
                 const char* title, const char* label, bool isTime) {
  MapChart chart{name, {title, "scene", "alpha", label, options.scenes, {}, {}, {}, 0, {}}};
  for (const double alpha : options.alphas) chart.map.columns.push_back(fmt::format("{:g}", alpha));
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k % options.alphas.size() == 0) {
      chart.map.values.emplace_back();
      chart.map.texts.emplace_back();
    }
    const Cell& cell = cells[k];
    chart.map.values.back().push_back(isTime ? cell.blowUpTime
                                             : cell.search.good().value_or(nothing));
    chart.map.texts.back().push_back(!isTime ? limitText(cell.search)
                                     : std::isnan(cell.blowUpTime)
                                         ? "-"
                                         : fmt::format("{:.2g}", cell.blowUpTime));
  }
  return chart;
}

}  // namespace

std::vector<std::string> timeStepScenes() {
  std::vector<std::string> names;
  for (const TimeStepScene& scene : scenes()) names.emplace_back(scene.name);
  return names;
}

void runTimeStep(const TimeStepOptions& options) {
  requireWords("--scenes", options.scenes, timeStepScenes());
  requireNumbers("--alpha", options.alphas, 0, 10);
  std::vector<Cell> cells = cellsOf(options);
  RunStore store(options.common.folder / "runs", Programs::find(options.common.programs),
                 options.common.quiet);
  Map map;
  map.name = "time_step";
  map.columns = {"scene", "alpha", "c dt/h", "dt [s]", "stands it", "failed at [s]", "failure"};
  for (int round = 1; searchOnce(cells, store, options.common, round, map); ++round) {
  }
  map.charts = {chartOf(options, cells, "time_step", "Largest step that a scene stands",
                        "c dt/h: stood - failed", false),
                chartOf(options, cells, "time_step_blow_up", "Blow-up one step beyond the limit",
                        "when a particle was too fast [s]", true)};
  for (const std::string& name : options.scenes) {
    const auto scene = std::ranges::find(scenes(), name, &TimeStepScene::name);
    map.remarks.push_back(fmt::format("{}: wrong is a particle above {:g} c within {:g} s; {}",
                                      name, scene->speedLimit, scene->endTime, scene->why));
  }
  if (std::ranges::any_of(cells, [](const Cell& cell) { return !cell.search.bad(); }))
    map.remarks.push_back(fmt::format(
        "all: every step up to {:g} h/c went well, above which plenum-sph refuses steps", highest));
  publish(map, options.common);
}

}  // namespace plenum::study
