// SPDX-License-Identifier: GPL-3.0-or-later
//
// [[validate]] of the case file: what a scene must show. plenum-ic checks its form and keeps it,
// plenum-sph evaluates it at the end of a run (solver/validation.hpp).
#pragma once

#include "particles/section.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum {

/// A published course in time.
struct CurveSettings {
  std::vector<double> times;   ///< ascending [s]
  std::vector<double> values;  ///< as many
};

/// One thing that a run must show: what is measured, and what it may be. Absent numbers are not
/// asked for. Either `expected` with one of the tolerances, or a curve with one, or bounds.
struct ValidateSettings {
  std::string quantity;         ///< a column of history.csv
  std::string statistic;        ///< as in the case; "": see statisticOrDefault
  std::optional<double> time;   ///< of "at" [s]
  std::optional<double> from;   ///< of what is taken over rows [s]
  std::optional<double> until;  ///< [s]
  std::optional<double> expected;
  std::optional<double> tolerance;          ///< of |measured - expected|
  std::optional<double> relativeTolerance;  ///< of |measured - expected| / |expected|
  std::optional<double> atLeast;
  std::optional<double> atMost;
  std::optional<CurveSettings> curve;
  std::string source;

  /// What is made of the column: as said, or "at" where there is a time, "" for a curve, or "last".
  std::string statisticOrDefault() const {
    if (!statistic.empty() || curve) return statistic;
    return time ? "at" : "last";
  }
};

const Section<ValidateSettings>& validateSection();

}  // namespace plenum
