// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/bisection.hpp"

#include <cmath>

namespace plenum::study {

Bisection::Bisection(double lowest, double highest, double precision)
    : lowest_(lowest), highest_(highest), precision_(precision) {}

std::optional<double> Bisection::next() const {
  const double low = good_.value_or(lowest_), high = bad_.value_or(highest_);
  if (low * precision_ < high) return std::sqrt(low * high);
  if (!good_ && !triedLowest_) return lowest_;
  if (!bad_ && !triedHighest_) return highest_;
  return std::nullopt;
}

void Bisection::record(double value, bool isGood) {
  // Of an end's own run: next() named it because the others were all bad, or all good.
  const std::optional<double> asked = next();
  triedLowest_ = triedLowest_ || asked == lowest_;
  triedHighest_ = triedHighest_ || asked == highest_;
  (isGood ? good_ : bad_) = value;
}

}  // namespace plenum::study
