// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum::study {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// What a cell shows: the number, or when its first run failed.
std::string textOfCell(const std::vector<RunOutcome>& seeds, double value) {
  double firstFailure = std::numeric_limits<double>::infinity();
  bool failed = false;
  for (const RunOutcome& outcome : seeds) {
    if (!outcome.hasFailed()) continue;
    failed = true;
    firstFailure = std::min(firstFailure, outcome.failureTime.value_or(firstFailure));
  }
  if (!std::isnan(value)) return fmt::format("{:.2g}{}", value, failed ? "!" : "");
  if (!failed) return "-";
  return std::isinf(firstFailure) ? "failed" : fmt::format("at {:.2g} s", firstFailure);
}

}  // namespace

GridAxis numberAxis(const std::string& name, const std::string& key,
                    const std::vector<double>& values) {
  GridAxis axis{name, {}};
  for (const double value : values)
    axis.values.push_back({fmt::format("{:g}", value), {fmt::format("{}={}", key, value)}});
  return axis;
}

GridAxis wordAxis(const std::string& name, const std::string& key,
                  const std::vector<std::string>& values) {
  GridAxis axis{name, {}};
  for (const std::string& value : values) axis.values.push_back({value, {key + "=" + value}});
  return axis;
}

Figure lastFigure(const std::string& name) {
  return [name](const RunOutcome& outcome) {
    return outcome.hasFailed() ? nothing : outcome.figure(name);
  };
}

double Grid::at(std::size_t row, std::size_t column, const Figure& figure) const {
  double sum = 0;
  int n = 0;
  for (const RunOutcome& outcome : outcomes[row][column])
    if (const double value = figure(outcome); !std::isnan(value)) {
      sum += value;
      ++n;
    }
  return n == 0 ? nothing : sum / n;
}

bool Grid::hasFailures(std::size_t row, std::size_t column) const {
  return std::ranges::any_of(outcomes[row][column], &RunOutcome::hasFailed);
}

HeatMap Grid::chart(const std::string& title, const std::string& valueLabel,
                    const Figure& figure) const {
  HeatMap map{title, plan.rows.name, plan.columns.name, valueLabel, {}, {}, {}, {}, {}, {}};
  for (const GridValue& column : plan.columns.values) map.columns.push_back(column.text);
  for (std::size_t r = 0; r < plan.rows.values.size(); ++r) {
    map.rows.push_back(plan.rows.values[r].text);
    map.values.emplace_back();
    map.texts.emplace_back();
    for (std::size_t c = 0; c < plan.columns.values.size(); ++c) {
      map.values[r].push_back(at(r, c, figure));
      map.texts[r].push_back(textOfCell(outcomes[r][c], map.values[r][c]));
    }
  }
  return map;
}

Chart Grid::overTime(const std::string& title, const std::string& column,
                     const std::string& unit) const {
  const std::size_t last = plan.columns.values.size() - 1;
  Chart chart{fmt::format("{}, {} = {}", title, plan.columns.name, plan.columns.values[last].text),
              {"t [s]", false, {}, {}},
              {unit.empty() ? column : fmt::format("{} [{}]", column, unit), false, 0, {}},
              {}};
  for (std::size_t r = 0; r < plan.rows.values.size(); ++r) {
    const RunOutcome& outcome = outcomes[r][last].front();
    Series series{plan.rows.values[r].text, SeriesStyle::linesAndPoints, {}, false};
    if (!std::filesystem::exists(outcome.folder / "history.csv")) continue;  // never began
    const HistoryColumn history = historyOf(outcome, column);
    for (std::size_t k = 0; k < history.times.size(); ++k)
      series.points.push_back({history.times[k], history.values[k],
                               fmt::format("{}: {:.3g}", series.name, history.values[k])});
    chart.series.push_back(std::move(series));
  }
  return chart;
}

void Grid::tabulate(const std::vector<std::pair<std::string, Figure>>& figures, Map& map) const {
  map.columns = {plan.rows.name, plan.columns.name, "seed"};
  for (const auto& [name, figure] : figures) map.columns.push_back(name);
  map.columns.insert(map.columns.end(), {"failed at [s]", "failure"});
  for (std::size_t r = 0; r < outcomes.size(); ++r)
    for (std::size_t c = 0; c < outcomes[r].size(); ++c)
      for (std::size_t s = 0; s < outcomes[r][c].size(); ++s) {
        const RunOutcome& outcome = outcomes[r][c][s];
        std::vector<std::string> row{plan.rows.values[r].text, plan.columns.values[c].text,
                                     std::to_string(s + 1)};
        for (const auto& [name, figure] : figures) {
          const double value = figure(outcome);
          row.push_back(std::isnan(value) ? "" : fmt::format("{:.6g}", value));
        }
        row.push_back(outcome.failureTime ? fmt::format("{:.6g}", *outcome.failureTime) : "");
        row.push_back(outcome.failure);
        map.rows.push_back(std::move(row));
      }
}

Grid runGrid(const GridPlan& plan, const MapOptions& options) {
  std::vector<RunRequest> requests;
  for (const GridValue& row : plan.rows.values)
    for (const GridValue& column : plan.columns.values)
      for (int seed = 1; seed <= plan.seeds; ++seed) {
        RunRequest request{plan.caseFile, plan.settings, 1, false};
        for (const auto* settings : {&row.settings, &column.settings})
          request.settings.insert(request.settings.end(), settings->begin(), settings->end());
        if (plan.variesSeed) request.settings.push_back(fmt::format("fluid[0].seed={}", seed));
        requests.push_back(std::move(request));
      }
  RunStore store(options.folder / "runs", Programs::find(options.programs), options.quiet);
  std::vector<RunOutcome> all = store.run(requests, options.jobs, plan.label);
  Grid grid{plan, {}};
  std::size_t next = 0;
  for (std::size_t r = 0; r < plan.rows.values.size(); ++r) {
    grid.outcomes.emplace_back(plan.columns.values.size());
    for (auto& cell : grid.outcomes[r])
      for (int seed = 0; seed < plan.seeds; ++seed) cell.push_back(std::move(all[next++]));
  }
  return grid;
}

}  // namespace plenum::study
