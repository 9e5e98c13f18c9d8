// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace plenum {

/// Times start + k every, `end` itself, and the `extra` times (ascending) between start and end.
/// Times are products, not sums, so that the millionth is as exact as the first. A time within
/// round-off of `end` is `end`; an extra one within round-off of a regular one is that. A time is
/// due from round-off before it, so that two schedules that meet need no step from one to the
/// other.
class Schedule {
 public:
  Schedule(double start, double every, double end, std::vector<double> extra = {})
      : start_(start), every_(every), end_(end), extra_(std::move(extra)) {
    skipExtraUntil(start);
  }

  double next() const {
    const double regular = nextRegular();
    const bool isExtra = at_ < extra_.size() && extra_[at_] < regular - roundOff();
    return isExtra ? extra_[at_] : regular;
  }
  bool isDue(double time) const { return !done_ && time >= next() - roundOff(); }

  /// The due time has been served.
  void advance() {
    const double served = next();
    done_ = served >= end_;
    if (served == nextRegular()) ++count_;
    skipExtraUntil(served);
  }

  /// All times until `time` have been served.
  void skipTo(double time) {
    while (isDue(time)) advance();
  }

 private:
  double roundOff() const { return 1e-9 * every_; }
  double nextRegular() const {
    const double t = start_ + static_cast<double>(count_) * every_;
    return t > end_ - roundOff() ? end_ : t;
  }
  void skipExtraUntil(double time) {
    while (at_ < extra_.size() && extra_[at_] <= time + roundOff()) ++at_;
  }

  double start_, every_, end_;
  std::vector<double> extra_;
  std::size_t at_ = 0;  // next of the extra ones
  long count_ = 1;      // the start itself is served by whoever begins
  bool done_ = false;
};

}  // namespace plenum
