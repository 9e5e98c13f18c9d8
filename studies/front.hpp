// SPDX-License-Identifier: GPL-3.0-or-later
//
// Error against cost: which settings nobody beats in both, and what they say.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace plenum::study {

struct CostAndError {
  double cost = 0, error = 0;  ///< any units; both positive
};

/// The Pareto front: places of the points that no other point beats in one without losing in the
/// other, by rising cost. Of equal points the first one stands for all.
std::vector<std::size_t> paretoFront(const std::vector<CostAndError>& points);

/// What reaching `error` costs along the front of `points`, linear between their logarithms. None
/// outside of the front's errors, or if it is a single point that has another error.
std::optional<double> costAtError(const std::vector<CostAndError>& points, double error);

}  // namespace plenum::study
