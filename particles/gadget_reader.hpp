// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/file_points.hpp"

#include <filesystem>

namespace plenum {

/// Where the gas particles of an HDF5 file of GADGET's layout stand [m]: /PartType0/Coordinates
/// times the unit of length that the file states (`Unit length in cgs (U_L)` of /Units as SWIFT
/// writes it, `UnitLength_in_cm` of /Parameters as GADGET-4 does), or as they are if it states
/// none. A particle file of this program gives its fluid particles in the scene's own coordinates.
///
/// Throws InputError for a file that is missing, not HDF5, without such coordinates, or one of
/// several of a snapshot.
FilePoints readGadgetPoints(const std::filesystem::path& path);

}  // namespace plenum
