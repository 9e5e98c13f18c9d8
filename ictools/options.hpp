// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plenum {

/// The command line of plenum-ic; each command uses some of it.
struct Options {
  std::string input;
  std::string output;
  std::vector<std::string> set;
  bool quick = false;
  bool quiet = false;
  bool markdown = false;
  bool noReport = false;
  std::string color = "velocity";  // these three of `preview`
  std::string slice;
  std::string column;
  bool smooth = false;
  std::vector<double> range;
  int width = 1200;            // [px]
  std::string kernel;          // of `report`
  double smoothingLength = 0;  // of `report` [d_ref]
  std::string json, png;
  std::string method;  // these three of `relax`
  std::optional<double> tolerance;
  std::optional<int> maxIterations;
};

}  // namespace plenum
