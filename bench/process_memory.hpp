// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace plenum::bench {

/// Memory that this process has now, and the most that it has had [bytes]: VmRSS and VmHWM.
std::size_t presentMemory();
std::size_t peakMemory();

/// Gives free memory back and lets the peak begin anew; whether the system allows that.
bool forgetPeakMemory();

}  // namespace plenum::bench
