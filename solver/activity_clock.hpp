// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <utility>

namespace plenum {

/// What a run spends its time on.
enum class Activity { stepping, measuring, writing, count };

/// Seconds by activity, of the clock on the wall and of all threads' CPU time. Each moment counts for one activity: a lap within a lap takes
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
  double cpuSeconds(Activity activity) const {
    return cpuSeconds_[static_cast<std::size_t>(activity)];
  }

 private:
  /// Returns the activity until now; `count` is none.
  Activity switchTo(Activity next) {
    const Clock::time_point now = Clock::now();
    const double cpu = cpuNow();
    const auto place = static_cast<std::size_t>(present_);
    seconds_[place] += std::chrono::duration<double>(now - start_).count();
    cpuSeconds_[place] += cpu - cpuStart_;
    start_ = now;
    cpuStart_ = cpu;
    return std::exchange(present_, next);
  }

  /// Of this process, in all threads [s].
  static double cpuNow() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  std::array<double, static_cast<std::size_t>(Activity::count) + 1> seconds_{}, cpuSeconds_{};
  Activity present_ = Activity::count;
  Clock::time_point start_ = Clock::now();
  double cpuStart_ = cpuNow();
};

}  // namespace plenum
