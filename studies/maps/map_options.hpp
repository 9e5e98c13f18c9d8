// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

/// What all maps are asked.
struct MapOptions {
  std::filesystem::path folder = "stability";  ///< of tables, charts, cases and runs
  std::filesystem::path programs;              ///< of plenum-ic and plenum-sph; empty: look
  int jobs = 1;                                ///< runs at once
  bool quick = false;                          ///< fewer seeds, shorter or coarser runs
  bool quiet = false;                          ///< remarks only
};

/// "1,2.5" or "box,tank" as values. Throws InputError, in one line, that names `option`, for what
/// is empty and for what should be a number and is none.
void readList(const std::string& option, const std::string& text, std::vector<double>& values);
void readList(const std::string& option, const std::string& text, std::vector<std::string>& values);

/// Values of an axis are numbers in [lowest, highest]. Throws InputError, in one line, that names
/// `option`, the value and the range, for others, for none and for one that stands there twice.
void requireNumbers(const std::string& option, const std::vector<double>& values, double lowest,
                    double highest);

/// The same for words that must be of `known`.
void requireWords(const std::string& option, const std::vector<std::string>& values,
                  const std::vector<std::string>& known);

/// Seeds 1 ... n: `asked`, or what the map takes in whole or in haste. Throws InputError for
/// numbers outside of 1 to 1000.
int seedsOf(const std::optional<int>& asked, const MapOptions& options, int whole, int quick);

}  // namespace plenum::study
