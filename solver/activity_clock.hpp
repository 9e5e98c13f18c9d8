// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <utility>

namespace plenum {

/// What a run spends its time on.
enum class Activity { stepping, measuring, writing, count };

/// Wall-clock seconds by activity. Each moment counts for one activity: a lap within a lap takes
/// its time from the outer one.
class ActivityClock {
 public:
  using Clock = std::chrono::steady_clock;

  /// Counts the time until its end for an activity.
  class Lap {
   public:
    Lap(ActivityClock& clock, Activity activity)
        : clock_(clock), outer_(clock.switchTo(activity)) {}
    ~Lap() { clock_.switchTo(outer_); }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

   private:
    ActivityClock& clock_;
    Activity outer_;
  };

  Lap lap(Activity activity) { return {*this, activity}; }
  double seconds(Activity activity) const { return seconds_[static_cast<std::size_t>(activity)]; }

 private:
  /// Returns the activity until now; `count` is none.
  Activity switchTo(Activity next) {
    const Clock::time_point now = Clock::now();
    seconds_[static_cast<std::size_t>(present_)] +=
        std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return std::exchange(present_, next);
  }

  std::array<double, static_cast<std::size_t>(Activity::count) + 1> seconds_{};
  Activity present_ = Activity::count;
  Clock::time_point start_ = Clock::now();
};

}  // namespace plenum
