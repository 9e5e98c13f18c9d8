// SPDX-License-Identifier: GPL-3.0-or-later
//
// CAD and mesh files through gmsh: .geo, .step, .stp, .brep, .msh. gmsh only reads and meshes the
// boundary; what is inside is CGAL's to say.
#pragma once

#include "geometry/polygon.hpp"
#include "geometry/triangle_soup.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace plenum {

struct CadLoops {
  std::vector<Loop> loops;
  double tolerance = 0;  ///< as asked for, or the default [m]
  double deviation = 0;  ///< largest distance measured between a curve and its polygon [m]
};

struct CadSurface {
  TriangleSoup soup;
  double tolerance = 0;  ///< as asked for, or the default [m]
  double deviation = 0;  ///< largest distance measured between a triangle and the surface [m]
};

/// The boundary lines of a flat file's surfaces, in the x-y plane; curves as polygons whose corners
/// lie on the curve and whose edges are at most `tolerance` [m] from it. Without a tolerance:
/// `relativeTolerance` times the diagonal of the bounds. Throws InputError with the remedy for a
/// file with volumes, without surfaces, or not flat.
CadLoops readCadLoops(const std::filesystem::path& path, std::optional<double> tolerance,
                      double relativeTolerance);

/// The outer surface of a file's volumes (or its closed surfaces) as triangles at most `tolerance`
/// [m] from it, normals outwards. Tried with finer meshes until the measured distance is small
/// enough. Throws InputError with the remedy for a flat file.
CadSurface readCadSurface(const std::filesystem::path& path, std::optional<double> tolerance,
                          double relativeTolerance);

}  // namespace plenum
