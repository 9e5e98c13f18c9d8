// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study of accuracy leaves: results.csv, charts, report.html.
#include "particles/atomic_file.hpp"
#include "particles/version.hpp"
#include "studies/accuracy.hpp"
#include "studies/chart.hpp"
#include "studies/closed_form.hpp"
#include "studies/numbers.hpp"
#include "studies/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace plenum::study {

namespace {

std::string axisLabel(const Study& study) {
  return study.unit.empty() ? study.measure.name()
                            : fmt::format("{} [{}]", study.measure.name(), study.unit);
}

std::string costLabel(const Study& study) {
  return study.isTimedByClock() ? "time of the steps by the clock [s]"
                                : "CPU time of the steps [s]";
}

std::string labelOf(const Study& study, const StudyRow& row) {
  return fmt::format("{}: {}, {:.3g} s", row.name, study.printed(*row.error), study.costOf(row));
}

/// Where a logarithmic axis shows runs without any error, as those are that do what the case does:
/// below the least of the others. None if there are no such runs.
std::optional<double> placeOfZero(const Study& study) {
  double least = std::numeric_limits<double>::infinity();
  bool hasZero = false;
  for (const std::size_t k : study.measuredRows()) {
    const double error = *study.rows[k].error;
    hasZero |= error == 0;
    if (error > 0) least = std::min(least, error);
  }
  if (!hasZero) return std::nullopt;
  return std::isfinite(least) ? least / 3 : 1;
}

/// Error against cost, a series for each value of the first axis, and the Pareto front.
Chart costChart(const Study& study) {
  const std::optional<double> zero = placeOfZero(study);
  Chart chart{study.settings.title + ": error against cost",
              {costLabel(study), true, {}, {}},
              {axisLabel(study), true, {}, {}, zero},
              {}};
  const auto height = [&](const StudyRow& row) {
    return *row.error > 0 ? *row.error : zero.value_or(0);
  };
  std::map<std::size_t, Series> series;
  for (const std::size_t k : study.measuredRows()) {
    const StudyRow& row = study.rows[k];
    const std::size_t first = row.at.empty() ? 0 : row.at[0];
    Series& one = series[first];
    one.name = study.axes.empty() ? "as the case" : describe({study.axes[0]}, {first});
    one.points.push_back({study.costOf(row), height(row), labelOf(study, row)});
  }
  for (auto& [value, one] : series) chart.series.push_back(std::move(one));
  Series front{"Pareto front", SeriesStyle::line, {}, true};  // numbered as frontLines does
  for (const std::size_t k : study.front())
    front.points.push_back(
        {study.costOf(study.rows[k]), height(study.rows[k]), labelOf(study, study.rows[k])});
  chart.series.push_back(std::move(front));
  return chart;
}

/// The front of costChart, from 1.
std::vector<std::string> frontLines(const Study& study) {
  std::vector<std::string> lines{"On the Pareto front, where nothing is both cheaper and better:"};
  for (const std::size_t k : study.front())
    lines.push_back(fmt::format("{}. {}", lines.size(), labelOf(study, study.rows[k])));
  return lines;
}

/// What rows have at a key of the case, where an axis varies it.
class VariedKey {
 public:
  VariedKey(const Study& study, const char* key) : study_(study) {
    for (std::size_t a = 0; a < study.axes.size(); ++a)
      for (std::size_t k = 0; k < study.axes[a].keys.size(); ++k)
        if (study.axes[a].keys[k] == key) place_ = {a, k};
  }

  bool isVaried() const { return place_.has_value(); }

  /// None where that is what the case has.
  std::optional<std::string> of(const StudyRow& row) const {
    if (!place_) return std::nullopt;
    const std::string& value =
        study_.axes[place_->first].values[row.at[place_->first]][place_->second];
    return value == "case" ? std::nullopt : std::optional(value);
  }

 private:
  const Study& study_;
  std::optional<std::pair<std::size_t, std::size_t>> place_;
};

double lengthOf(const Study& study, const StudyRow& row, const VariedKey& key) {
  const std::optional<std::string> text = key.of(row);
  return text ? numberIn(*text).value() : study.settings.solverOrDefaults().smoothingLength;
}

/// As the case names it, without the quotation marks that TOML allows.
std::string kernelOf(const Study& study, const StudyRow& row, const VariedKey& key) {
  std::string name = key.of(row).value_or(study.settings.solverOrDefaults().kernel);
  std::erase_if(name, [](char c) { return c == '"' || c == '\''; });
  return name;
}

/// The entry of [[validate]] that the closed form is of, the mean with its sign; or the study's.
std::size_t entryOfMean(const Study& study) {
  const auto& all = study.settings.validations;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].quantity == study.measure.quantity && all[k].statisticOrDefault() == "mean")
      return k;
  return study.measure.entry;
}

/// The points of one kernel at each smoothing length, and the closed form through them.
std::vector<Series> columnSeries(const Study& study, const HydrostaticColumn& column,
                                 const std::string& kernel, const std::vector<std::size_t>& rows,
                                 const VariedKey& length) {
  Series measured{kernel, SeriesStyle::points, {}, false};
  Series expected{"", SeriesStyle::line, {}, false};
  const std::size_t entry = entryOfMean(study);
  double lowest = 10, highest = 0;
  for (const std::size_t k : rows) {
    const StudyRow& row = study.rows[k];
    const auto& value = row.outcome.validation.at(entry).measured;
    const double h = lengthOf(study, row, length);
    if (!value) continue;
    measured.points.push_back({h, std::abs(*value), labelOf(study, row)});
    lowest = std::min(lowest, h);
    highest = std::max(highest, h);
  }
  for (double h = lowest; h < highest + 0.005; h += 0.01)
    expected.points.push_back({h, std::abs(column.error(kernel, h)), ""});
  return {measured, expected};
}

/// Keys that the closed form does not depend on.
bool leavesClosedForm(const std::string& key) {
  for (const char* known :
       {"solver.kernel", "solver.smoothing_length", "spacing", "solver.precision",
        "solver.time_step", "threads", "time_step_factor", "solver.viscosity", "solver.collisions"})
    if (key == known) return true;
  return false;
}

/// For a column of water at rest whose smoothing length is varied: the closed form of its error.
std::optional<Chart> columnChart(const Study& study) {
  const auto column = HydrostaticColumn::of(study.settings);
  const VariedKey length(study, "solver.smoothing_length"), kernel(study, "solver.kernel");
  if (!column || !length.isVaried() || study.measure.quantity != "pressure_gradient_error")
    return std::nullopt;
  for (const Variation& axis : study.axes)
    if (!std::ranges::all_of(axis.keys, leavesClosedForm)) return std::nullopt;
  std::map<std::string, std::vector<std::size_t>> rowsOf;
  for (const std::size_t k : study.measuredRows())
    rowsOf[kernelOf(study, study.rows[k], kernel)].push_back(k);
  if (rowsOf.empty()) return std::nullopt;
  const std::string name = study.settings.validations[entryOfMean(study)].quantity;
  Chart chart{study.settings.title + ": measured (points) and in closed form (lines)",
              {"h/d_ref", false, {}, {}},
              {fmt::format("|mean of {}| [{}]", name, study.unit), true, {}, {}},
              {}};
  for (const auto& [named, rows] : rowsOf)
    for (Series& series : columnSeries(study, *column, named, rows, length))
      chart.series.push_back(std::move(series));
  return chart;
}

PageTable pageTable(const Study& study) {
  PageTable table;
  for (const Variation& axis : study.axes)
    table.columns.insert(table.columns.end(), axis.names.begin(), axis.names.end());
  for (const std::string& name :
       {axisLabel(study), costLabel(study), std::string("remark"), std::string("all CPU time [s]"),
        std::string("peak memory [MiB]"), std::string("million interactions a second"),
        std::string("steps"), std::string("particles")})
    table.columns.push_back(name);
  const std::vector<std::size_t> front = study.front();
  for (std::size_t k = 0; k < study.rows.size(); ++k) {
    const StudyRow& row = study.rows[k];
    const RunOutcome& run = row.outcome;
    std::vector<std::string> cells;
    for (std::size_t a = 0; a < study.axes.size(); ++a)
      for (std::size_t n = 0; n < study.axes[a].names.size(); ++n)
        cells.push_back(study.axes[a].textOf(row.at[a], n));
    const bool hasSteps = run.steps > 0;  // one that failed before has cost nothing to compare
    cells.push_back(row.error ? fmt::format("{:.4g}", *row.error) : "");
    cells.push_back(hasSteps ? fmt::format("{:.3g}", study.costOf(row)) : "");
    cells.push_back(run.hasFailed()                    ? "failed: " + run.failure
                    : !row.error                       ? "no value of " + study.measure.name()
                    : std::ranges::count(front, k) > 0 ? "front"
                                                       : "");
    cells.push_back(hasSteps ? fmt::format("{:.3g}", run.cost.cpuSeconds) : "");
    cells.push_back(hasSteps ? fmt::format("{:.1f}", run.cost.peakBytes / 1048576) : "");
    cells.push_back(hasSteps ? fmt::format("{:.1f}", 1e-6 * run.cost.interactionsPerSecond) : "");
    cells.push_back(std::to_string(run.steps));
    cells.push_back(std::to_string(run.fluidParticles + run.wallParticles));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// The last states of the front's runs, and of those that failed.
std::vector<PagePicture> picturesOf(const Study& study) {
  std::vector<std::size_t> shown = study.front();
  for (std::size_t k = 0; k < study.rows.size(); ++k)
    if (study.rows[k].outcome.hasFailed()) shown.push_back(k);
  std::vector<PagePicture> pictures;
  for (const std::size_t k : shown) {
    const RunOutcome& run = study.rows[k].outcome;
    const auto png = run.folder / (run.hasFailed() ? "failed.png" : "last.png");
    if (pictures.size() < 12 && std::filesystem::exists(png))
      pictures.push_back({png, study.rows[k].name + (run.hasFailed() ? ": failed" : "")});
  }
  return pictures;
}

}  // namespace

void writeAccuracy(const Study& study, const AccuracyOptions& options) {
  writeTextFile(options.folder / "results.csv", csvOf(study));
  PagePart findings{"What the runs say", sentencesOf(study, options), {}, {}, {}};
  if (!study.measuredRows().empty())
    for (std::string& line : frontLines(study)) findings.paragraphs.push_back(std::move(line));
  const auto add = [&](const Chart& chart, const std::string& name) {
    writeChart(options.folder / name, chart);
    findings.svgs.push_back(svgOf(chart, name));
  };
  if (!study.measuredRows().empty()) add(costChart(study), "error_cost");
  for (const char* ending : {".svg", ".png"})  // of another study in this folder
    std::filesystem::remove(options.folder / (std::string("closed_form") + ending));
  if (const auto chart = columnChart(study)) add(*chart, "closed_form");
  const std::string how = fmt::format(
      "{} runs of {} by plenum-study {}, {} at once. Costs are seconds of plenum-sph in steps, "
      "without measures and files.",
      study.rows.size(), study.caseFile.filename().string(), version, options.jobs);
  const Page page{study.settings.title + ": speed against accuracy",
                  {std::move(findings),
                   {"All runs", {how}, {}, pageTable(study), {}},
                   {"Final states", {}, {}, {}, picturesOf(study)}}};
  writeTextFile(options.folder / "report.html", htmlOf(page));
}

}  // namespace plenum::study
