// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace plenum::study {

/// What all maps are asked.
struct MapOptions {
  std::filesystem::path folder = "stability";  ///< of tables, charts, cases and runs
  std::filesystem::path programs;              ///< of plenum-ic and plenum-sph; empty: look
  int jobs = 1;                                ///< runs at once
  bool quick = false;                          ///< fewer seeds, shorter or coarser runs
  bool quiet = false;                          ///< remarks only
};

/// Seeds 1 ... n: `asked`, or what the map takes in whole or in haste. Throws InputError for
/// numbers outside of 1 to 1000.
int seedsOf(const std::optional<int>& asked, const MapOptions& options, int whole, int quick);

}  // namespace plenum::study
