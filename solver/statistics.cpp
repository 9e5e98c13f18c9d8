// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plenum {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Times of rows are products and sums of steps: the same time to so much.
double roundOffOf(double time) { return 1e-9 * std::max(1e-12, std::abs(time)); }

/// Of of(x) over time.
template <class Of>
double meanOf(const Series& s, Of&& of) {
  if (s.times.size() == 1) return of(s.values[0]);
  double area = 0;
  for (std::size_t k = 1; k < s.times.size(); ++k)
    area += 0.5 * (s.times[k] - s.times[k - 1]) * (of(s.values[k]) + of(s.values[k - 1]));
  return area / (s.times.back() - s.times.front());
}

}  // namespace

Series seriesOf(std::span<const double> times, std::span<const double> values, double from,
                double until) {
  Series series;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double roundOff = roundOffOf(times[k]);
    if (std::isnan(values[k]) || times[k] < from - roundOff || times[k] > until + roundOff)
      continue;
    series.times.push_back(times[k]);
    series.values.push_back(values[k]);
  }
  return series;
}

double valueAt(const Series& s, double time) {
  if (s.times.empty()) return none;
  const double roundOff = roundOffOf(time);
  const auto after = std::ranges::lower_bound(s.times, time - roundOff);
  if (after == s.times.end()) return none;
  const auto k = static_cast<std::size_t>(after - s.times.begin());
  if (*after <= time + roundOff) return s.values[k];
  if (k == 0) return none;
  const double t = (time - s.times[k - 1]) / (s.times[k] - s.times[k - 1]);
  return (1 - t) * s.values[k - 1] + t * s.values[k];
}

double statisticOf(const Series& s, const std::string& name) {
  if (s.times.empty()) return none;
  if (name == "last") return s.values.back();
  if (name == "min") return *std::ranges::min_element(s.values);
  if (name == "max") return *std::ranges::max_element(s.values);
  if (name == "mean") return meanOf(s, [](double x) { return x; });
  if (name == "mean_abs") return meanOf(s, [](double x) { return std::abs(x); });
  const bool isRelative = name == "relative_drift";
  if (name != "drift" && !isRelative) throw std::invalid_argument("no statistic is called " + name);
  double drift = 0;
  for (const double x : s.values) drift = std::max(drift, std::abs(x - s.values.front()));
  if (!isRelative) return drift;
  return s.values.front() != 0 ? drift / std::abs(s.values.front()) : none;
}

}  // namespace plenum
