// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/study.hpp"

#include "studies/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plenum::study {

namespace {

std::string numberCell(std::optional<double> value) {
  return value ? fmt::format("{}", *value) : "";
}

std::vector<std::string> headerOf(const Study& study) {
  std::vector<std::string> names;
  for (const Variation& axis : study.axes)
    for (const std::string& name : axis.names) names.push_back(csvCell(name));
  names.push_back(csvCell("error of " + study.measure.name() +
                          (study.unit.empty() ? "" : " [" + study.unit + "]")));
  for (const ValidateSettings& asked : study.settings.validations) {
    const std::string statistic = asked.statisticOrDefault();
    names.push_back(csvCell(statistic.empty() ? asked.quantity : asked.quantity + ":" + statistic));
  }
  for (const char* name :
       {"cpu in steps [s]", "cpu [s]", "wall clock in steps [s]", "wall clock [s]", "instructions",
        "peak memory [bytes]", "updates [1/s]", "interactions [1/s]", "steps", "fluid particles",
        "wall particles", "failure", "failed at [s]", "folder"})
    names.emplace_back(name);
  return names;
}

std::vector<std::string> cellsOf(const Study& study, const StudyRow& row) {
  std::vector<std::string> cells;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    for (std::size_t n = 0; n < study.axes[a].names.size(); ++n)
      cells.push_back(csvCell(study.axes[a].textOf(row.at[a], n)));
  cells.push_back(numberCell(row.error));
  const RunOutcome& run = row.outcome;
  for (std::size_t k = 0; k < study.settings.validations.size(); ++k)
    cells.push_back(k < run.validation.size() ? numberCell(run.validation[k].measured) : "");
  const RunCost& cost = run.cost;
  for (const double value :
       {cost.stepCpuSeconds, cost.cpuSeconds, cost.stepWallSeconds, cost.wallSeconds})
    cells.push_back(run.steps > 0 ? fmt::format("{:.4g}", value) : "");
  cells.push_back(numberCell(cost.instructions));
  for (const double value : {cost.peakBytes, cost.updatesPerSecond, cost.interactionsPerSecond})
    cells.push_back(fmt::format("{:.0f}", value));
  for (const long count : {run.steps, run.fluidParticles, run.wallParticles})
    cells.push_back(std::to_string(count));
  cells.push_back(csvCell(run.failure));
  cells.push_back(numberCell(run.failureTime));
  cells.push_back(csvCell(run.folder.filename().string()));
  return cells;
}

}  // namespace

bool Study::isTimedByClock() const { return std::ranges::any_of(axes, &Variation::isOfThreads); }

double Study::costOf(const RunOutcome& outcome) const {
  return isTimedByClock() ? outcome.cost.stepWallSeconds : outcome.cost.stepCpuSeconds;
}

const RunOutcome& Study::leastOf(const std::vector<RunOutcome>& outcomes) const {
  return *std::ranges::min_element(outcomes, {}, [&](const RunOutcome& outcome) {
    return std::pair(outcome.hasFailed(), costOf(outcome));
  });
}

std::vector<std::size_t> Study::measuredRows() const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].error) found.push_back(k);
  return found;
}

std::vector<CostAndError> Study::pointsOf(const std::vector<std::size_t>& which) const {
  std::vector<CostAndError> points;
  for (const std::size_t k : which) points.push_back({costOf(rows[k]), rows[k].error.value()});
  return points;
}

std::vector<std::size_t> Study::wholeFront() const {
  const std::vector<std::size_t> measured = measuredRows();
  std::vector<std::size_t> places;
  for (const std::size_t k : paretoFront(pointsOf(measured))) places.push_back(measured[k]);
  return places;
}

std::vector<std::size_t> Study::front() const {
  std::vector<std::size_t> places;
  for (const std::size_t k : wholeFront())
    if (places.empty() || *rows[k].error < 0.99 * *rows[places.back()].error) places.push_back(k);
  return places;
}

std::string Study::printed(double error) const {
  return unit.empty() ? fmt::format("{:.3g}", error) : fmt::format("{:.3g} {}", error, unit);
}

std::string unitOf(const Study& study) {
  const ValidateSettings& asked = study.settings.validations.at(study.measure.entry);
  if (study.measure.scale || (asked.curve && asked.relativeTolerance)) return "";
  for (const StudyRow& row : study.rows)
    if (study.measure.entry < row.outcome.validation.size())
      return row.outcome.validation[study.measure.entry].unit;
  return "";
}

std::string csvOf(const Study& study) {
  std::string text = fmt::format("{}\n", fmt::join(headerOf(study), ","));
  for (const StudyRow& row : study.rows)
    text += fmt::format("{}\n", fmt::join(cellsOf(study, row), ","));
  return text;
}

}  // namespace plenum::study
