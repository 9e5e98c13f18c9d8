// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <omp.h>

#include <array>
#include <chrono>
#include <string_view>

namespace plenum {

/// Parts of a step, for the question where its time goes.
enum class Part { sort, search, load, pairs, integrate, count };

inline constexpr std::array<std::string_view, static_cast<std::size_t>(Part::count)> partNames{
    "sort", "search", "load", "pairs", "integrate"};

/// Wall-clock seconds of the first thread by part. Reading the clock takes some 30 ns, a step some
/// ten readings and six more a chunk.
class Stopwatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// Counts the time until its end for a part.
  class Lap {
   public:
    Lap(Stopwatch& watch, Part part) : watch_(watch), part_(part) {
      if (counts_) start_ = Clock::now();
    }
    ~Lap() {
      if (counts_)
        watch_.seconds_[static_cast<std::size_t>(part_)] +=
            std::chrono::duration<double>(Clock::now() - start_).count();
    }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

   private:
    Stopwatch& watch_;
    Part part_;
    bool counts_ = omp_get_thread_num() == 0;
    Clock::time_point start_;
  };

  Lap lap(Part part) { return {*this, part}; }
  double seconds(Part part) const { return seconds_[static_cast<std::size_t>(part)]; }
  void reset() { seconds_ = {}; }

 private:
  std::array<double, static_cast<std::size_t>(Part::count)> seconds_{};
};

}  // namespace plenum
