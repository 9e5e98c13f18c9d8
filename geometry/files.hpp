// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "geometry/mend_surface.hpp"
#include "geometry/placement.hpp"
#include "geometry/thicken.hpp"

#include <filesystem>
#include <optional>

namespace plenum {

/// How a file becomes a region.
template <int Dim>
struct FileOptions {
  /// Largest distance between the represented surface and the CAD file's curved one [m], after
  /// scaling; absent: `defaultTolerance` times the diagonal of the file's bounds. Files of straight
  /// edges and triangles (.wkt, .stl, .msh, ...) are taken as they are: there it only states how
  /// far they may be from what is meant.
  std::optional<double> tolerance;
  Placement<Dim> placement;
  /// Makes a wall of an open surface or line, after it is put into its place.
  std::optional<Thickening> thickening;
  MendOptions mend;                            ///< of triangle meshes
  FindingSink report = [](const Finding&) {};  ///< told what was mended

  static constexpr double defaultTolerance = 1e-4;
};

/// Reads a region, by the file's ending:
///   2-D: .wkt, .txt, .xy, .dat (polygon, see polygon_file.hpp), .geo, .step, .stp, .brep, .msh
///   3-D: .stl, .obj, .off, .ply (closed triangle mesh), .geo, .step, .stp, .brep, .msh
/// With a thickness: open lines (.wkt, .txt, .xy, .dat) and open triangle meshes (.stl, .obj, .off,
/// .ply). Triangles are mended (mend_surface.hpp) before they are checked. Throws InputError that
/// names the file, what is wrong, where, and the remedy; a file that is too large for the memory is
/// refused before it is read.
template <int Dim>
GeometryPtr<Dim> readGeometryFile(const std::filesystem::path& path,
                                  const FileOptions<Dim>& options = {});

}  // namespace plenum
