// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pre-flight: everything that is wrong with a case, or worth knowing, before it is generated.
#pragma once

#include "ictools/check_parts.hpp"
#include "ictools/estimate.hpp"
#include "particles/findings.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plenum {

struct CheckReport {
  std::string caseName;
  Findings findings;
  std::vector<PartSize> parts;
  std::optional<Estimate> estimate;  ///< none if fluids or walls are at fault
};

/// Reads a case as `generate` does and goes on after errors: a broken file is one finding, the rest
/// of the case is still checked. Up to `maxCounted` expected particles the case is filled, so that
/// the checks of `generate` that need particles are made, too. `settings` are values "key=value"
/// instead of the file's. Throws what is no fault of the input.
CheckReport checkCase(const std::filesystem::path& path, const std::vector<std::string>& settings,
                      bool quick = false);

inline constexpr double maxCounted = 2e6;

/// For the terminal: a line and its remedy for each finding, errors first; sizes; what it costs.
std::string describe(const CheckReport& report);

/// For programs: {"case", "sound", "findings": [{"severity", "what", "remedy", "place" [m]}],
/// "parts": [{"name", "extent" [m], "extent_in_spacings"}], "estimate": {...}}.
std::string toJson(const CheckReport& report);

}  // namespace plenum
