// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace plenum {

/// Memory that this program may still take without swapping [bytes]: what the machine has to spare
/// (MemAvailable of /proc/meminfo) or its limit of address space (ulimit -v) leaves, the smaller
/// one. Nothing where the machine does not say.
std::optional<double> availableMemory();

/// "3.2 GB", "15 MB", "800 bytes".
std::string printedBytes(double bytes);

}  // namespace plenum
