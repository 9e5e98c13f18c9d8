// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/errors.hpp"
#include "studies/numbers.hpp"
#include "studies/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace plenum::study {

namespace {

/// A round error in the middle of the front, that it reaches.
double errorInTheMiddle(const Study& study, const std::vector<std::size_t>& front) {
  const double best = *study.rows[front.back()].error;
  const double middle = *study.rows[front[front.size() / 2]].error;
  const double rounded = middle > 0 ? roundedDown(middle) : 0;
  return rounded >= best ? rounded : middle;
}

/// What paying more than for a row buys, on the front that charts show: the first place that costs
/// twice as much or more, or the last one.
std::string whatMoreBuys(const Study& study, const StudyRow& here) {
  const StudyRow* more = nullptr;
  for (const std::size_t k : study.front()) {
    const StudyRow& row = study.rows[k];
    if (*row.error >= 0.99 * *here.error) continue;
    more = &row;
    if (study.costOf(row) >= 2 * study.costOf(here)) break;
  }
  if (more == nullptr) return "no dearer setting of this study is more accurate";
  return fmt::format("paying {:.2g} times as much buys {} ({}, {:.3g} s)",
                     study.costOf(*more) / study.costOf(here), study.printed(*more->error),
                     more->name, study.costOf(*more));
}

/// A setting of a comparison: the value of each axis that it names.
using Chosen = std::map<std::size_t, std::size_t>;

Chosen chosenIn(const Study& study, const std::string& text) {
  Chosen chosen;
  for (const std::string& part : splitOutsideBrackets(text, ',')) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string name = part.substr(0, equals);
    const auto axis = std::ranges::find_if(
        study.axes, [&](const Variation& known) { return known.name() == name; });
    if (axis == study.axes.end()) {
      std::vector<std::string> names;
      for (const Variation& known : study.axes) names.push_back(known.name());
      throw InputError(fmt::format("--compare {}: the study does not vary '{}'; it varies {}", text,
                                   name, fmt::join(names, ", ")));
    }
    std::vector<std::string> values;
    for (std::size_t k = 0; k < axis->values.size(); ++k) values.push_back(axis->textOf(k));
    const auto value = std::ranges::find(values, part.substr(std::min(equals + 1, part.size())));
    if (value == values.end())
      throw InputError(
          fmt::format("--compare {}: {} is none of {}", text, part, fmt::join(values, ", ")));
    chosen[static_cast<std::size_t>(axis - study.axes.begin())] =
        static_cast<std::size_t>(value - values.begin());
  }
  if (chosen.empty()) throw InputError("--compare: write AXIS=VALUE,AXIS=VALUE for each setting");
  return chosen;
}

bool isNumeric(const Variation& axis) {
  return axis.names.size() == 1 && std::ranges::all_of(axis.values, [](const auto& value) {
           return numberIn(value[0]).has_value();
         });
}

/// Rows that agree with `row` along axes that nobody chose, and with `chosen` but for numbers.
std::vector<std::size_t> curveOf(const Study& study, const Chosen& chosen, const StudyRow& row) {
  std::vector<std::size_t> curve;
  for (const std::size_t k : study.measuredRows()) {
    bool belongs = true;
    for (std::size_t a = 0; a < study.axes.size(); ++a) {
      const auto value = chosen.find(a);
      const bool isFree = value != chosen.end() && isNumeric(study.axes[a]);
      const std::size_t wanted = value == chosen.end() ? row.at[a] : value->second;
      belongs &= isFree || study.rows[k].at[a] == wanted;
    }
    if (belongs) curve.push_back(k);
  }
  return curve;
}

bool agrees(const StudyRow& row, const Chosen& chosen) {
  return std::ranges::all_of(chosen, [&](const auto& c) { return row.at[c.first] == c.second; });
}

std::string nameOf(const Study& study, const Chosen& chosen) {
  std::vector<Variation> axes;
  std::vector<std::size_t> at;
  for (const auto& [axis, value] : chosen) {
    axes.push_back(study.axes[axis]);
    at.push_back(value);
  }
  return describe(axes, at);
}

}  // namespace

std::vector<std::string> adviceOf(const Study& study, std::vector<double> errors) {
  const std::vector<std::size_t> front = study.wholeFront();
  if (front.empty())
    return {std::ranges::all_of(study.rows, [](const auto& row) { return row.outcome.hasFailed(); })
                ? "All runs of this study failed: there is nothing to advise."
                : fmt::format("No run of this study has a value of {}: there is nothing to advise.",
                              study.measure.name())};
  const bool isChosen = errors.empty();
  if (isChosen) errors.push_back(errorInTheMiddle(study, front));
  std::vector<std::string> sentences;
  for (const double error : errors) {
    const auto found =
        std::ranges::find_if(front, [&](std::size_t k) { return *study.rows[k].error <= error; });
    if (found == front.end()) {
      sentences.push_back(fmt::format(
          "No run of this study is within {}; the best is {}: {}.", study.printed(error),
          study.printed(*study.rows[front.back()].error), study.rows[front.back()].name));
      continue;
    }
    const StudyRow& row = study.rows[*found];
    sentences.push_back(
        fmt::format("The cheapest setting {}{}: {}: {}, {:.3g} s; {}.",
                    error > 0 ? "within " + study.printed(error) : "without any error",
                    isChosen ? " (--within asks for other errors)" : "", row.name,
                    study.printed(*row.error), study.costOf(row), whatMoreBuys(study, row)));
  }
  return sentences;
}

void requireComparable(const Study& study, const std::string& one, const std::string& other) {
  chosenIn(study, one);
  chosenIn(study, other);
}

std::string comparisonOf(const Study& study, const std::string& one, const std::string& other) {
  const Chosen a = chosenIn(study, one), b = chosenIn(study, other);
  double logSum = 0, errorSum = 0;
  int n = 0;
  for (const StudyRow& row : study.rows) {
    if (!row.error || !agrees(row, a)) continue;
    const std::optional<double> cost =
        costAtError(study.pointsOf(curveOf(study, b, row)), *row.error);
    if (!cost) continue;
    logSum += std::log(*cost / study.costOf(row));
    errorSum += *row.error;
    ++n;
  }
  const std::string nameA = nameOf(study, a), nameB = nameOf(study, b);
  if (n == 0)
    return fmt::format(
        "{} and {} cannot be compared at equal error: no runs of the second enclose "
        "the error of the first.",
        nameA, nameB);
  const double ratio = std::exp(logSum / n);
  return fmt::format(
      "At the error of {} ({}), {} with its numbers chosen for that error costs {:.2f} times as "
      "much (geometric mean of {} pair{} of runs): {} is cheaper at equal error.",
      nameA, study.printed(errorSum / n), nameB, ratio, n, n == 1 ? "" : "s",
      ratio < 1 ? nameB : nameA);
}

}  // namespace plenum::study
