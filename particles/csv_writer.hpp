// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"

#include <filesystem>

namespace plenum {

/// Writes particles as text, one a line: all state fields of the set in the order of the field
/// table, a column for each component of a vector, and `type` (0 fluid, 1 wall). The first line
/// names the columns, with the unit [SI] in brackets: "position_x [m]". Numbers have as many digits
/// as it takes to read the same bits back. Where a particle does not carry a field it has 0, or -1
/// for labels. The file appears under its name only when it is complete.
///
/// Throws InputError for a set without particles and RunError if the file cannot be written.
template <int Dim>
void writeCsv(const std::filesystem::path& path, const ParticleSet<Dim>& particles);

}  // namespace plenum
