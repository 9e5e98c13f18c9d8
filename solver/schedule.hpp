// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace plenum {

/// Times start + k every, and `end` itself. Times are products, not sums, so that the millionth is
/// as exact as the first. A time within round-off of `end` is `end`.
class Schedule {
 public:
  Schedule(double start, double every, double end) : start_(start), every_(every), end_(end) {}

  double next() const {
    const double t = start_ + static_cast<double>(count_) * every_;
    return t > end_ - 1e-9 * every_ ? end_ : t;
  }
  bool isDue(double time) const { return !done_ && time >= next(); }

  /// The due time has been served.
  void advance() {
    done_ = next() >= end_;
    ++count_;
  }

 private:
  double start_, every_, end_;
  long count_ = 1;  // the start itself is served by whoever begins
  bool done_ = false;
};

}  // namespace plenum
