// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/maps/map_options.hpp"

#include "studies/lists.hpp"

namespace plenum::study {

int seedsOf(const std::optional<int>& asked, const MapOptions& options, int whole, int quick) {
  const int seeds = asked.value_or(options.quick ? quick : whole);
  requireNumbers("--seeds", {static_cast<double>(seeds)}, 1, 1000);
  return seeds;
}

}  // namespace plenum::study
