// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"

#include <optional>
#include <string>

namespace plenum {

/// A setting that does not go with the others.
struct Conflict {
  std::string key;     ///< in [solver], as "viscosity.laminar"
  std::string value;   ///< of the key, where that says more
  std::string why;     ///< goes on after the key and its value
  std::string remedy;  ///< what to do instead
};

/// The first thing of a gas, or of smoothing lengths of the particles' own, that the rest of the
/// settings does not allow; both programs ask for it.
std::optional<Conflict> conflictOf(const SolverSettings& settings, int dimension);

/// The same for a table of a case: throws InputError that names the key, also for keys that have no
/// effect with the table's equation of state.
void checkSolverTable(const SolverSettings& settings, const CaseNode& table, int dimension);

}  // namespace plenum
