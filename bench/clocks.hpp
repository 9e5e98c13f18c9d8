// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

namespace plenum::bench {

/// Seconds by the clock on the wall and of all processors that this process has used.
struct Times {
  double wall = 0, cpu = 0;

  friend Times operator-(Times a, Times b) { return {a.wall - b.wall, a.cpu - b.cpu}; }
  friend Times operator+(Times a, Times b) { return {a.wall + b.wall, a.cpu + b.cpu}; }

  /// CPU time of one thread, which other programs disturb least; wall time of several.
  double counted(int threads) const { return threads == 1 ? cpu : wall; }
};

inline Times now() {
  const auto read = [](clockid_t clock) {
    timespec t{};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  return {read(CLOCK_MONOTONIC), read(CLOCK_PROCESS_CPUTIME_ID)};
}

}  // namespace plenum::bench
