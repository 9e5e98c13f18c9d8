// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "studies/outcome.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

/// How far runs are from what one entry of their case's [[validate]] expects.
struct ErrorMeasure {
  std::size_t entry = 0;  ///< of [[validate]]
  std::string quantity;   ///< "pressure_gradient_error"
  std::string statistic;  ///< "mean_abs"; of a curve empty
  /// Errors are |measured - expected|; else the measure is an error by itself and its size counts.
  bool isDifference = false;
  std::optional<double> scale;      ///< |expected|, where errors are relative to it
  std::optional<double> reference;  ///< what is expected, where a run of the case says that

  /// "pressure_gradient_error (mean_abs)"
  std::string name() const;

  /// None for a run that failed, or that has no value there.
  std::optional<double> of(const RunOutcome& outcome) const;
};

/// A measure of how far runs are, relatively, from one that is taken for right: an entry of
/// [[validate]] that need not expect anything itself, but has one value. Throws InputError as
/// errorMeasureNamed does.
ErrorMeasure measureAgainstCase(const CaseSettings& settings, const std::string& asked);

/// That run. Throws RunError if it failed or has no value other than zero.
void takeReference(ErrorMeasure& measure, const RunOutcome& outcome);

/// One for each entry of a case that can be taken as an error: a quantity that is an error, a norm
/// or a drift, a curve, or one with an expected value; none for mere bounds.
std::vector<ErrorMeasure> errorMeasuresOf(const CaseSettings& settings);

/// The one that is asked for as "QUANTITY" or "QUANTITY:STATISTIC", or the first. Throws InputError
/// that lists those that the case has.
ErrorMeasure errorMeasureNamed(const CaseSettings& settings, const std::string& asked);

}  // namespace plenum::study
