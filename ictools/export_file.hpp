// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

namespace plenum {

/// Writes the particles of the particle file `from`, walls included, as `to`: .vtu (vtu_writer.hpp)
/// or .csv (csv_writer.hpp). Returns their number. Throws InputError for a file that cannot be read
/// and for another ending, RunError if `to` cannot be written.
std::size_t exportFile(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace plenum
