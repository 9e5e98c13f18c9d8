// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"

#include <filesystem>
#include <optional>

namespace plenum {

struct VtuOptions {
  double time = 0;                      ///< [s], as field data TimeValue
  std::optional<FieldSet> fields = {};  ///< what to write; absent: all state fields of the set
};

/// Writes particles for ParaView and meshio: a .vtu file with one vertex cell a particle, points
/// and vectors with three components, an array `type` (0 fluid, 1 wall), and every field under its
/// name of the field table (0, or -1 for labels, where a particle does not carry it). Appended raw
/// binary, zlib-compressed. The file appears under its name only when it is complete.
///
/// Throws InputError for a set without particles (meshio cannot read such a file) and for a field
/// that the set does not carry; RunError if the file cannot be written.
template <int Dim>
void writeVtu(const std::filesystem::path& path, const ParticleSet<Dim>& particles,
              const VtuOptions& options = {});

}  // namespace plenum
