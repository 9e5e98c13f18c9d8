// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum::study {

namespace {

CaseSettings readBase(const AccuracyOptions& options) {
  CaseNode root = CaseNode::load(options.caseFile);
  applyChanges(root, options.quick, options.settings);
  return readCase(root);
}

}  // namespace

ErrorMeasure measureFor(const AccuracyOptions& options, const CaseSettings& settings,
                        RunStore& store) {
  if (!options.isAgainstCase) return errorMeasureNamed(settings, options.quantity);
  ErrorMeasure measure = measureAgainstCase(settings, options.quantity);
  takeReference(
      measure,
      store.run({{options.caseFile, options.settings, 1, options.quick, 0}}, 1, "the case itself")
          .front());
  return measure;
}

Study runAccuracy(const AccuracyOptions& options) {
  Study study;
  study.caseFile = options.caseFile;
  study.settings = readBase(options);
  for (const std::string& text : options.vary)
    study.axes.push_back(Variation::parse(text, options.caseFile));
  const std::vector<Combination> grid =
      gridOf(study.axes, {options.caseFile, options.settings, 1, options.quick});
  std::vector<RunRequest> requests;
  // Rounds of all runs, so that a busy minute of the machine does not meet one setting's only.
  for (int repeat = 0; repeat < options.repeats; ++repeat)
    for (const Combination& point : grid) {
      requests.push_back(point.request);
      requests.back().repeat = repeat;
    }
  RunStore::requireUsable({requests.begin(), requests.begin() + std::ssize(grid)});
  for (const auto& [one, other] : options.comparisons) requireComparable(study, one, other);
  RunStore store(options.folder / "runs", Programs::find(options.programs), options.quiet);
  study.measure = measureFor(options, study.settings, store);
  const std::vector<RunOutcome> outcomes = store.run(requests, options.jobs, "accuracy");
  for (std::size_t k = 0; k < grid.size(); ++k) {
    std::vector<RunOutcome> repeated;
    for (std::size_t at = k; at < outcomes.size(); at += grid.size())
      repeated.push_back(outcomes[at]);
    const RunOutcome& least = study.leastOf(repeated);
    study.rows.push_back(
        {grid[k].at, describe(study.axes, grid[k].at), least, study.measure.of(least)});
  }
  study.unit = unitOf(study);
  return study;
}

std::vector<std::string> sentencesOf(const Study& study, const AccuracyOptions& options) {
  std::vector<std::string> sentences = adviceOf(study, options.within);
  for (const auto& [one, other] : options.comparisons)
    sentences.push_back(comparisonOf(study, one, other));
  const auto nFailed = std::ranges::count_if(
      study.rows, [](const StudyRow& row) { return row.outcome.hasFailed(); });
  const auto nWithout = std::ranges::count_if(
      study.rows, [](const StudyRow& row) { return !row.outcome.hasFailed() && !row.error; });
  if (nWithout > 0)
    sentences.push_back(
        fmt::format("{} of {} runs ended without a value of {}: was it over before "
                    "the time that [[validate]] names?",
                    nWithout, study.rows.size(), study.measure.name()));
  if (nFailed > 0)
    sentences.push_back(fmt::format("{} of {} runs failed; results.csv has their reasons.", nFailed,
                                    study.rows.size()));
  return sentences;
}

std::string tableOf(const Study& study) {
  std::size_t width = 8;
  for (const StudyRow& row : study.rows) width = std::max(width, row.name.size());
  std::vector<std::size_t> front = study.front();
  std::string text = fmt::format("{:{}}  {:>12}  {:>9}  {:>8}  {:>11}\n", "setting", width,
                                 study.unit.empty() ? "error" : "error [" + study.unit + "]",
                                 "steps [s]", "MiB", "M pairs/s");
  for (std::size_t k = 0; k < study.rows.size(); ++k) {
    const StudyRow& row = study.rows[k];
    text += fmt::format("{:{}}  ", row.name, width);
    if (row.outcome.hasFailed())
      text += fmt::format("failed: {}\n", row.outcome.failure);
    else
      text += fmt::format("{:>12}  {:>9.3g}  {:>8.1f}  {:>11.1f}{}\n",
                          row.error ? fmt::format("{:.4g}", *row.error) : "no value",
                          study.costOf(row), row.outcome.cost.peakBytes / 1048576,
                          1e-6 * row.outcome.cost.interactionsPerSecond,
                          std::ranges::count(front, k) > 0 ? "  front" : "");
  }
  return text;
}

}  // namespace plenum::study
