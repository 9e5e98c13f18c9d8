// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "studies/front.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace plenum::study {

/// A setting that may be tried.
struct Candidate {
  double work = 0;         ///< what its run is thought to cost, in any unit
  double spacing = 0;      ///< d_ref [m]
  std::size_t family = 0;  ///< the same number for settings that differ in their spacing only
};

struct Search {
  std::optional<std::size_t> found;  ///< the cheapest candidate within the error, of those tried
  std::vector<std::size_t> tried;    ///< in this order
};

/// Which candidate meets `error` at the least cost, without running those that cost more.
///
/// Candidates are tried by rising work. What a setting costs is known once its run is done; the
/// search ends when all that is left is thought to cost more than the best found, by a margin for
/// what the estimate may be wrong. A family is not tried on finer particles where its errors on
/// coarser ones leave no chance: by the order that two of them show, or by second order where only
/// one is known.
///
/// `run` gives cost and error of a candidate, or none if its run failed.
Search findCheapest(const std::vector<Candidate>& candidates, double error,
                    const std::function<std::optional<CostAndError>(std::size_t)>& run);

}  // namespace plenum::study
