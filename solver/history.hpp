// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/figure.hpp"

#include <filesystem>
#include <fstream>
#include <vector>

namespace plenum {

/// history.csv: one row a measurement, units in the header. Every row is complete on disk as soon
/// as it is added, so that a run can be watched and a killed one leaves what it had.
class History {
 public:
  /// Throws InputError if a file is there and has other columns than `figures`.
  static void requireColumns(const std::filesystem::path& path, const std::vector<Figure>& figures);

  /// A new file. Throws RunError if it cannot be written.
  explicit History(std::filesystem::path path);
  /// Goes on with the file, if there is one: the rows until `time` [s] are kept, what comes after
  /// them is dropped. Throws RunError.
  History(std::filesystem::path path, double time);

  /// The rows that were kept.
  const std::vector<std::vector<Figure>>& earlierRows() const { return earlier_; }

  /// All rows must have the same figures; those that are NaN leave an empty cell.
  void add(const std::vector<Figure>& figures);

 private:
  std::filesystem::path path_;
  std::ofstream out_;
  std::string header_;  // "" until the first row
  std::vector<std::vector<Figure>> earlier_;
};

}  // namespace plenum
