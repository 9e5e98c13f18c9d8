// SPDX-License-Identifier: GPL-3.0-or-later
//
// The particle file (.hdf, HDF5): what plenum-ic hands to plenum-sph, and a checkpoint of a run.
// One file, three readers (docs: formats):
//   /Header /Units /PartType0   GADGET and SWIFT: coordinates in [0, BoxSize), three components
//   /VTKHDF                     ParaView: hard links to the same arrays; /VTKHDF/Points stands in
//                               the scene's own coordinates, as a dataset of its own if they
//                               differ from /PartType0/Coordinates
//   /Plenum                     the scene: case text, materials, walls, container, quality figures
//
// Row i of every array is particle i of the set: fluid first, then walls. ParticleTypes (0 fluid,
// 1 wall) is made from that order. Fields that a particle does not carry are 0, labels -1.
// Velocities, Masses, Density, InternalEnergy, SmoothingLength and ParticleIDs are always there for
// GADGET's readers; /Plenum attribute Fields names those that are real. ParticleIDs are the set's
// own; a set without ids gets 1..Nw for walls, then Nw+1.. for fluids.
#pragma once

#include "particles/scene.hpp"

#include <filesystem>
#include <utility>

namespace plenum {

/// Writes all state fields of the scene; rates and other scratch fields are left out. The file
/// appears under its name only when it is complete. Throws RunError (no such folder, full disk, a
/// position that is not finite) and InputError for a scene without particles. Other values that are
/// not finite are written, so that a run that failed can be looked at; reading refuses them.
template <int Dim>
void writeParticleFile(const std::filesystem::path& path, const Scene<Dim>& scene);

/// The scene as it was written, bit by bit. Throws InputError for a file that is missing, not HDF5,
/// truncated, of another program or schema version, and for arrays that are missing, disagree in
/// length, hold values that are not finite or labels of no material or wall.
template <int Dim>
Scene<Dim> readParticleFile(const std::filesystem::path& path);

/// 1, 2 or 3. Throws InputError as above.
int particleFileDimension(const std::filesystem::path& path);

/// Reads a file of any dimension: returns `visit(Scene<Dim>)`.
template <class Visit>
auto withParticleFile(const std::filesystem::path& path, Visit&& visit) {
  switch (particleFileDimension(path)) {
    case 1:
      return visit(readParticleFile<1>(path));
    case 2:
      return visit(readParticleFile<2>(path));
    default:
      return visit(readParticleFile<3>(path));
  }
}

}  // namespace plenum
