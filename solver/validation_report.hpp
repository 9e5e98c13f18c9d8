// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/validation.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace plenum {

/// A table for people: quantity, what is expected, what was measured, verdict, source; "" if there
/// is nothing to show.
std::string printed(const std::vector<ValidationResult>& results);

/// The same as a JSON list of objects, with the numbers in full; a value that was not measured is
/// null. Throws RunError if the file cannot be written.
void writeValidation(const std::filesystem::path& path,
                     const std::vector<ValidationResult>& results);

}  // namespace plenum
