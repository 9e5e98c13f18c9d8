// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study minimal: the cheapest setting of a case that meets an error, and what it may do
// without.
#pragma once

#include "studies/accuracy.hpp"
#include "studies/cheapest.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

/// Something that the case was run without.
struct TriedWithout {
  std::string what;
  bool isLeftOut = false;
  std::optional<double> error;  ///< without it; none if the run failed
  double cost = 0;              ///< without it [s]
  std::string failure;          ///< why there is no error
  std::string loss;             ///< of what the case says in [[validate]], in words
  RunOutcome outcome;           ///< without it
};

struct Minimal {
  Study tried;                       ///< the settings that were run
  std::size_t nOfGrid = 0;           ///< all settings that the case can have
  std::optional<std::size_t> found;  ///< row of `tried`
  double searchCost = 0;             ///< of the runs of the search, steps only [s]
  std::vector<TriedWithout> without;
  std::optional<CaseNode> root;  ///< the case that models no more than it needs
  RunOutcome outcome;            ///< of it
  std::optional<double> error;   ///< of it
  double cost = 0;               ///< of it [s]
};

/// Searches the grid of options.vary, or, if that is empty, kernels, smoothing lengths, and the
/// case's spacing and two and four times it. Then takes away from the setting found, one after the
/// other, what leaves the error within `error`, does not cost more, and for terms of the solver
/// leaves alone what else the case shows of its [[validate]]. Of the grid that nobody asked for,
/// settings that the case cannot have are left out. Throws InputError, before anything runs, for
/// settings that cannot be used.
Minimal findMinimal(const AccuracyOptions& options, double error);

/// What was found, for people.
std::vector<std::string> sentencesOf(const Minimal& minimal, double error);

}  // namespace plenum::study
