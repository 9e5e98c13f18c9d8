// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/process_memory.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

namespace plenum::bench {

namespace {

std::size_t statusEntry(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == name) {
      std::size_t kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  return 0;
}

}  // namespace

std::size_t presentMemory() { return statusEntry("VmRSS:"); }
std::size_t peakMemory() { return statusEntry("VmHWM:"); }

bool forgetPeakMemory() {
  malloc_trim(0);
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush;
  return file.good();
}

}  // namespace plenum::bench
