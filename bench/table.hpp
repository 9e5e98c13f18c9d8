// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/suite.hpp"

#include <string>

namespace plenum::bench {

/// One line a case, medians over its repetitions.
std::string tableOf(const Runs& runs);

}  // namespace plenum::bench
