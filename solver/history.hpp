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
  /// Throws RunError if the file cannot be written.
  explicit History(std::filesystem::path path);

  /// All rows must have the same figures; those that are NaN leave an empty cell.
  void add(const std::vector<Figure>& figures);

 private:
  std::filesystem::path path_;
  std::ofstream out_;
  bool hasHeader_ = false;
};

}  // namespace plenum
