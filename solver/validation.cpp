// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/validation.hpp"

#include "particles/errors.hpp"
#include "solver/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace plenum {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const Figure& figureNamed(const std::string& name, const std::vector<Figure>& row, std::size_t k) {
  std::vector<std::string> known;
  for (const Figure& figure : row) {
    if (figure.name == name) return figure;
    known.push_back(figure.name);
  }
  const std::string near = nearest(name, known);
  throw InputError(fmt::format(
      "validate[{}].quantity = \"{}\": the run has no such column in history.csv; {}", k, name,
      near.empty() ? fmt::format("it has {}", fmt::join(known, ", "))
                   : "did you mean \"" + near + "\"?"));
}

/// The last time that an entry needs; -infinity: whatever the run has.
double lastTimeOf(const ValidateSettings& v) {
  if (v.curve) return v.curve->times.back();
  if (v.time) return *v.time;
  return v.until.value_or(v.from.value_or(-infinity));
}

/// Mean over the curve's points of |measured - value|, or of that over |value|. NaN if a point has
/// no value.
double deviationFrom(const CurveSettings& curve, const Series& series, bool relative) {
  double sum = 0;
  for (std::size_t k = 0; k < curve.times.size(); ++k) {
    const double difference = std::abs(valueAt(series, curve.times[k]) - curve.values[k]);
    sum += relative ? difference / std::abs(curve.values[k]) : difference;
  }
  return sum / static_cast<double>(curve.times.size());
}

/// NaN cells count as such where a time is named; statistics leave them out.
double measuredOf(const ValidateSettings& v, const Series& rows) {
  if (v.curve) return deviationFrom(*v.curve, rows, v.relativeTolerance.has_value());
  if (v.time) return valueAt(rows, *v.time);
  return statisticOf(
      seriesOf(rows.times, rows.values, v.from.value_or(-infinity), v.until.value_or(infinity)),
      v.statisticOrDefault());
}

bool isAsAsked(const ValidateSettings& v, double measured) {
  if (v.curve) return measured <= v.relativeTolerance.value_or(v.tolerance.value_or(0));
  if (v.expected) {
    const double scale = v.relativeTolerance ? std::abs(*v.expected) : 1;
    const double tolerance = v.relativeTolerance.value_or(v.tolerance.value_or(0));
    return std::abs(measured - *v.expected) <= tolerance * scale;
  }
  return measured >= v.atLeast.value_or(-infinity) && measured <= v.atMost.value_or(infinity);
}

}  // namespace

const char* nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::ok:
      return "ok";
    case Verdict::failed:
      return "FAILED";
    case Verdict::notReached:
      return "not reached";
    case Verdict::noValue:
      break;
  }
  return "no value";
}

Validation::Validation(std::vector<ValidateSettings> asked, const std::vector<Figure>& row)
    : asked_(std::move(asked)) {
  for (std::size_t k = 0; k < asked_.size(); ++k) {
    const Figure& figure = figureNamed(asked_[k].quantity, row, k);
    const auto known = std::ranges::find(columns_, figure.name, &Column::name);
    columnOf_.push_back(static_cast<std::size_t>(known - columns_.begin()));
    if (known == columns_.end()) columns_.push_back({figure.name, figure.unit, {}});
  }
}

std::vector<double> Validation::timesOf(const std::vector<ValidateSettings>& asked) {
  std::set<double> times;
  for (const ValidateSettings& v : asked) {
    for (const auto& time : {v.time, v.from, v.until})
      if (time) times.insert(*time);
    if (v.curve) times.insert(v.curve->times.begin(), v.curve->times.end());
  }
  return {times.begin(), times.end()};
}

void Validation::addRow(const std::vector<Figure>& row) {
  const double time = valueOf(row, "time");
  while (!times_.empty() && times_.back() >= time) {
    times_.pop_back();
    for (Column& column : columns_) column.values.pop_back();
  }
  times_.push_back(time);
  for (Column& column : columns_) column.values.push_back(valueOf(row, column.name));
}

std::vector<ValidationResult> Validation::evaluate() const {
  std::vector<ValidationResult> results;
  for (std::size_t k = 0; k < asked_.size(); ++k) {
    const ValidateSettings& v = asked_[k];
    const Column& column = columns_[columnOf_[k]];
    ValidationResult result{v, column.unit, std::nullopt, Verdict::noValue};
    // Up to the end as valueAt understands it: a run that ends there has reached it.
    const double end = times_.empty() ? -infinity : times_.back(), needed = lastTimeOf(v);
    if (end < needed - 1e-9 * std::abs(needed)) {
      result.verdict = Verdict::notReached;
    } else {
      const double measured = measuredOf(v, {times_, column.values});
      if (!std::isnan(measured)) {
        result.measured = measured;
        result.verdict = isAsAsked(v, measured) ? Verdict::ok : Verdict::failed;
      }
    }
    results.push_back(std::move(result));
  }
  return results;
}

bool allOk(const std::vector<ValidationResult>& results) {
  return std::ranges::all_of(results, [](const auto& r) { return r.verdict == Verdict::ok; });
}

}  // namespace plenum
