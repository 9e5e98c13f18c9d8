// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"

#include <filesystem>

namespace plenum {

/// Puts the particles of a fluid where the file of its `positions` has them, relative to `folder`:
/// .vtu (vtu_reader.hpp), .csv (csv_points.hpp), .hdf5 and .hdf (gadget_reader.hpp). Points on the
/// region's surface (fill.hpp) are taken; on periodic axes a point on the upper face stands on the
/// lower one. `warn` is told of walls that the file has and that are left out.
///
/// Throws InputError for a file that cannot be read or is empty, for coordinates that are not
/// finite or, along axes that the case does not have, not all the same, and for points outside of
/// the region or the periodic domain, or at the place of another one: each with their number, the
/// place of the worst and the remedy.
template <int Dim>
void placeFromFile(FluidFill<Dim>& fluid, const std::filesystem::path& folder,
                   const SceneFrame<Dim>& frame, const Warn& warn);

/// Throws InputError, with what stands at `node`, if points lie outside of the fluid's region or of
/// the periodic domain.
template <int Dim>
void checkInside(const FluidFill<Dim>& fluid, const std::vector<Vec<Dim>>& points,
                 const SceneFrame<Dim>& frame, const CaseNode& node);

}  // namespace plenum
