// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_node.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

/// A case that models less than another one.
struct LeaveOut {
  std::string what;  ///< "the air", "collisions", for people
  CaseNode root;     ///< the case without it
};

/// What a case may do without, one at a time, the costliest first: two dimensions instead of three
/// where it says that it is uniform along an axis, each fluid but the first, each physical term and
/// refinement of [solver] that is not needed to run. What only exists for a fluid that is left out,
/// its measures and expectations, goes with it.
std::vector<LeaveOut> leaveOutsOf(const CaseNode& root);

}  // namespace plenum::study
