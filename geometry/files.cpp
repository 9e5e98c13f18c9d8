// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files.hpp"

#include "geometry/cad_file.hpp"
#include "geometry/mesh_file.hpp"
#include "geometry/polygon_file.hpp"
#include "geometry/surface_check.hpp"
#include "geometry/surface_mesh.hpp"
#include "geometry/text_reader.hpp"
#include "particles/errors.hpp"
#include "particles/findings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum {

namespace {

enum class Kind { polygon, mesh, cad };

Kind kindOf(const std::filesystem::path& path, int dimension) {
  const std::string extension = extensionOf(path);
  const auto isOneOf = [&](std::initializer_list<const char*> known) {
    return std::ranges::find(known, extension) != known.end();
  };
  if (isOneOf({".geo", ".step", ".stp", ".brep", ".msh"})) return Kind::cad;
  if (isOneOf({".wkt", ".txt", ".xy", ".dat"})) {
    if (dimension == 2) return Kind::polygon;
    throw InputError(path.string() +
                     ": a polygon file is 2-D, the case has dimension = 3; give a "
                     "closed triangle mesh or a CAD file, or make a solid of it with extrude");
  }
  if (isOneOf({".stl", ".obj", ".off", ".ply"})) {
    if (dimension == 3) return Kind::mesh;
    throw InputError(path.string() +
                     ": a triangle mesh is 3-D, the case has dimension = 2; give a "
                     "polygon file (.wkt) or a flat CAD file");
  }
  throw InputError(path.string() + ": files that end in '" + extension +
                   "' are not read; give .geo .step .stp .brep .msh" +
                   (dimension == 2 ? " .wkt .txt .xy .dat" : " .stl .obj .off .ply"));
}

Loop moved(Loop loop, const Placement<2>& placement) {
  for (Vec<2>& x : loop) x = placement.apply(x);
  return loop;
}

/// What a file of straight edges and triangles may be off is the user's to say.
template <int Dim>
double stated(const FileOptions<Dim>& options) {
  return options.tolerance.value_or(0);
}

GeometryPtr<2> placedPolygon(std::vector<PolygonLoops> polygons, const Placement<2>& placement,
                             const std::string& source, double tolerance) {
  for (PolygonLoops& polygon : polygons) {
    polygon.outer = moved(polygon.outer, placement);
    for (Loop& hole : polygon.holes) hole = moved(hole, placement);
  }
  return makePolygon(std::move(polygons), source, tolerance);
}

/// Runs `make`, which makes a region of what was thickened; where that crosses itself the thickness
/// may be to blame.
template <class Make>
auto withThickness(const Thickening& how, Make&& make) {
  try {
    return make();
  } catch (const InputError& error) {
    std::vector<Finding> findings = findingsOf(error);
    for (Finding& finding : findings) {
      finding.what += fmt::format(" (with thickness = {})", how.thickness);
      finding.remedy = remedyForThickness(how) + ", or mend the file if it is so without";
    }
    throw FaultyInput(std::move(findings));
  }
}

GeometryPtr<2> thickenedLines(std::vector<Loop> lines, const FileOptions<2>& options,
                              const std::string& source) {
  for (Loop& line : lines) line = moved(line, options.placement);
  std::vector<PolygonLoops> walls = thickened(lines, *options.thickening, source);
  return withThickness(*options.thickening,
                       [&] { return makePolygon(walls, source, stated(options)); });
}

GeometryPtr<3> placedMesh(TriangleSoup soup, const FileOptions<3>& options,
                          const std::string& source, double tolerance) {
  checkFinite(soup, source);
  for (Vec<3>& x : soup.points) x = options.placement.apply(x);
  const TriangleSoup clean = mended(soup, options.mend, source, options.report);
  if (!options.thickening) return makeSurfaceMesh(clean, source, tolerance);
  const TriangleSoup wall = thickened(clean, *options.thickening, source, options.report);
  return withThickness(*options.thickening,
                       [&] { return makeSurfaceMesh(wall, source, tolerance); });
}

void refuseThickCad(const std::filesystem::path& path, bool hasThickness,
                    const std::string& instead) {
  if (hasThickness)
    throw InputError(path.string() +
                     ": thickness is for open lines and open triangle meshes, and the faces of a "
                     "CAD file have no order; model the wall as a solid there, or export " +
                     instead);
}

bool isMsh(const std::filesystem::path& path) { return extensionOf(path) == ".msh"; }

/// The tolerance in the file's own lengths.
template <int Dim>
std::optional<double> inFile(const FileOptions<Dim>& options) {
  if (!options.tolerance) return std::nullopt;
  return *options.tolerance / options.placement.scale;
}

}  // namespace

template <>
GeometryPtr<2> readGeometryFile<2>(const std::filesystem::path& path,
                                   const FileOptions<2>& options) {
  const Kind kind = kindOf(path, 2);
  if (kind == Kind::polygon && options.thickening)
    return thickenedLines(readLineFile(path), options, path.string());
  if (kind == Kind::polygon)
    return placedPolygon(readPolygonFile(path), options.placement, path.string(), stated(options));
  refuseThickCad(path, options.thickening.has_value(), "the line as LINESTRING (.wkt)");
  CadLoops cad = readCadLoops(path, inFile(options), options.defaultTolerance);
  return placedPolygon(nestedLoops(cad.loops, path.string()), options.placement, path.string(),
                       isMsh(path) ? stated(options) : cad.tolerance * options.placement.scale);
}

template <>
GeometryPtr<3> readGeometryFile<3>(const std::filesystem::path& path,
                                   const FileOptions<3>& options) {
  if (kindOf(path, 3) == Kind::mesh)
    return placedMesh(readMeshFile(path), options, path.string(), stated(options));
  refuseThickCad(path, options.thickening.has_value(), "the surface as a mesh (.stl)");
  const CadSurface cad = readCadSurface(path, inFile(options), options.defaultTolerance);
  return placedMesh(cad.soup, options, path.string(),
                    isMsh(path) ? stated(options) : cad.tolerance * options.placement.scale);
}

}  // namespace plenum
