// SPDX-License-Identifier: GPL-3.0-or-later
//
// What [[validate]] makes of a column in time. NaN stands for a value that is not there.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace plenum {

/// Values at ascending times [s], without those that are NaN.
struct Series {
  std::vector<double> times;
  std::vector<double> values;
};

/// The part of a column with from <= time <= until, to round-off of the times.
Series seriesOf(std::span<const double> times, std::span<const double> values, double from,
                double until);

/// Linear between the two nearest times; NaN before the first and after the last one.
double valueAt(const Series& series, double time);

/// "last", "min", "max", "mean", "mean_abs" (over time, by the trapezoidal rule; of a single value
/// that value), "drift", the largest |x - x_first|, or "relative_drift", that over |x_first|; NaN
/// of an empty series. Throws std::invalid_argument for another name.
double statisticOf(const Series& series, const std::string& name);

}  // namespace plenum
