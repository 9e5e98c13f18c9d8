// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

namespace plenum::bench {

/// What is set up once, in a process of its own.
struct Case {
  std::string scene;  ///< "dam_break", "quiet_gas" or "ideal_gas"
  int dimension = 2;
  std::string precision;  ///< "mixed" or "double"
  std::size_t n = 0;      ///< fluid particles, about

  bool isDamBreak() const { return scene == "dam_break"; }
  bool isIdealGas() const { return scene == "ideal_gas"; }
  std::string name() const { return fmt::format("{}/{}d/{}/n:{}", scene, dimension, precision, n); }
  auto operator<=>(const Case&) const = default;
};

/// What the command line asks for.
struct Choice {
  std::vector<std::string> scenes{"dam_break", "quiet_gas", "ideal_gas"};
  std::vector<int> dimensions{2, 3};
  std::vector<std::string> precisions{"mixed", "double"};
  std::vector<int> threads;
  double smallest = 1e4, largest = 1e6;
  bool full = false;         ///< double at the largest sizes, too
  double running = 1e5;      ///< most particles whose dam break is really run
  int repetitions = 0;       ///< 0: five, three from a million on
  double seconds = 0.25;     ///< least time of a measurement
  std::string filter = ".";  ///< of names
  std::string json;
  std::string states = "out/bench";
};

/// Whether a case begins from a dam break that was run from rest (running_state.hpp).
inline bool isReallyRun(const Case& c, const Choice& choice) {
  return c.isDamBreak() && static_cast<double>(c.n) <= choice.running;
}

/// The cases of each size, smallest first.
std::vector<std::vector<Case>> casesOf(const Choice& choice);

}  // namespace plenum::bench
