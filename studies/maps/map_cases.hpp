// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace plenum::study {

/// The case of cases/ that a map varies, as this program was built with it, is written to
/// FOLDER/cases/NAME.toml, where it can be read and run by hand. Throws RunError if it cannot be
/// written.
std::filesystem::path writeMapCase(const std::filesystem::path& folder, const std::string& name);

/// What a case sets that a step is compared with: c [m/s] and h [m].
struct Scales {
  double soundSpeed = 0, smoothingLength = 0;
};
Scales scalesOf(const std::filesystem::path& caseFile, bool quick);

}  // namespace plenum::study
