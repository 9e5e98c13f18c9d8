// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/error_measure.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace plenum::study {

namespace {

/// A measure that is zero where all is right. Momentum, which all methods here keep to rounding,
/// tells none from another.
bool isErrorByName(const std::string& quantity, const std::string& statistic) {
  if (quantity.starts_with("momentum_")) return false;
  const auto has = [&](const char* word) { return quantity.find(word) != std::string::npos; };
  return has("error") || has("drift") || quantity.starts_with("l1_") ||
         quantity.starts_with("l2_") || statistic.find("drift") != std::string::npos;
}

}  // namespace

std::string ErrorMeasure::name() const {
  return statistic.empty() || statistic == "at" || statistic == "last"
             ? quantity
             : fmt::format("{} ({})", quantity, statistic);
}

std::optional<double> ErrorMeasure::of(const RunOutcome& outcome) const {
  if (outcome.hasFailed() || entry >= outcome.validation.size()) return std::nullopt;
  const Validated& found = outcome.validation[entry];
  const std::optional<double> expected = reference ? reference : found.expected;
  if (!found.measured || (isDifference && !expected)) return std::nullopt;
  const double error = std::abs(isDifference ? *found.measured - *expected : *found.measured);
  return scale ? error / *scale : error;
}

std::vector<ErrorMeasure> errorMeasuresOf(const CaseSettings& settings) {
  std::vector<ErrorMeasure> measures;
  for (std::size_t k = 0; k < settings.validations.size(); ++k) {
    const ValidateSettings& asked = settings.validations[k];
    ErrorMeasure measure{k, asked.quantity, asked.statisticOrDefault(), false, {}, {}};
    if (!isErrorByName(asked.quantity, measure.statistic) && !asked.curve) {
      if (!asked.expected) continue;
      measure.isDifference = true;
      if (asked.relativeTolerance && *asked.expected != 0)
        measure.scale = std::abs(*asked.expected);
    }
    measures.push_back(measure);
  }
  return measures;
}

namespace {

/// The first of `measures` that is asked for, or the first.
ErrorMeasure namedAmong(const std::vector<ErrorMeasure>& measures, const CaseSettings& settings,
                        const std::string& asked) {
  if (asked.empty()) return measures.front();
  const std::size_t colon = asked.find(':');
  for (const ErrorMeasure& measure : measures)
    if (measure.quantity == asked.substr(0, colon) &&
        (colon == std::string::npos || measure.statistic == asked.substr(colon + 1)))
      return measure;
  std::vector<std::string> known;
  for (const ErrorMeasure& measure : measures)
    known.push_back(measure.statistic.empty() ? measure.quantity
                                              : measure.quantity + ":" + measure.statistic);
  throw InputError(fmt::format("--quantity {}: the case \"{}\" cannot be held to it; it has {}",
                               asked, settings.title, fmt::join(known, ", ")));
}

}  // namespace

ErrorMeasure errorMeasureNamed(const CaseSettings& settings, const std::string& asked) {
  const std::vector<ErrorMeasure> measures = errorMeasuresOf(settings);
  if (measures.empty())
    throw InputError(fmt::format(
        "the case \"{}\" has no [[validate]] entry that is an error or has an expected value: "
        "nothing to hold accuracy to; add one, or take a run of the case for right with "
        "--against-case",
        settings.title));
  return namedAmong(measures, settings, asked);
}

ErrorMeasure measureAgainstCase(const CaseSettings& settings, const std::string& asked) {
  std::vector<ErrorMeasure> measures;
  for (std::size_t k = 0; k < settings.validations.size(); ++k)
    if (!settings.validations[k].curve)
      measures.push_back({k,
                          settings.validations[k].quantity,
                          settings.validations[k].statisticOrDefault(),
                          true,
                          {},
                          {}});
  if (measures.empty())
    throw InputError(
        fmt::format("the case \"{}\" has no [[validate]] entry with one value to "
                    "compare runs by; add one",
                    settings.title));
  return namedAmong(measures, settings, asked);
}

void takeReference(ErrorMeasure& measure, const RunOutcome& outcome) {
  if (outcome.hasFailed())
    throw RunError(fmt::format("the case itself failed, so nothing can be compared with it: {}",
                               outcome.failure));
  if (measure.entry >= outcome.validation.size() || !outcome.validation[measure.entry].measured ||
      *outcome.validation[measure.entry].measured == 0)
    throw RunError(
        fmt::format("the case itself has no value of {}, or zero, so nothing can be "
                    "compared with it",
                    measure.name()));
  measure.reference = outcome.validation[measure.entry].measured;
  measure.scale = std::abs(*measure.reference);
}

}  // namespace plenum::study
