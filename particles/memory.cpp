// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>

namespace plenum {

namespace {

/// The value of a line "Name:  123 kB" of a file of /proc [bytes].
std::optional<double> valueIn(const char* file, const std::string& name) {
  std::ifstream in(file);
  std::string word;
  double kilobytes = 0;
  while (in >> word)
    if (word == name && in >> kilobytes) return 1024 * kilobytes;
  return std::nullopt;
}

}  // namespace

std::optional<double> availableMemory() {
  std::optional<double> available = valueIn("/proc/meminfo", "MemAvailable:");
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return available;
  const double left = std::max(0., static_cast<double>(limit.rlim_cur) -
                                       valueIn("/proc/self/status", "VmSize:").value_or(0));
  return std::min(available.value_or(left), left);
}

std::string printedBytes(double bytes) {
  if (bytes < 1e3) return fmt::format("{:.0f} bytes", bytes);
  if (bytes < 1e6) return fmt::format("{:.3g} kB", bytes / 1e3);
  if (bytes < 1e9) return fmt::format("{:.3g} MB", bytes / 1e6);
  return fmt::format("{:.3g} GB", bytes / 1e9);
}

}  // namespace plenum
