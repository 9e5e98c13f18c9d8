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
  /// A part of the scene, a fluid or a dimension, without which other quantities than the one asked
  /// for may mean something else; no term of the solver.
  bool isOfScene = false;
};

/// What a case may do without, one at a time, the costliest first: two dimensions instead of three
/// where it says that it is uniform along an axis, each fluid but the first, each physical term and
/// refinement of [solver] that is not needed to run. Measures of a fluid that
/// is left out go with it; [[validate]] stays as it is.
std::vector<LeaveOut> leaveOutsOf(const CaseNode& root);

}  // namespace plenum::study
