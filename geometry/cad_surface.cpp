// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cad_file.hpp"
#include "geometry/gmsh_session.hpp"
#include "geometry/mend_surface.hpp"
#include "geometry/print.hpp"
#include "geometry/text_reader.hpp"
#include "particles/errors.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace plenum {

namespace {

constexpr int triangle = 2;  // gmsh's number of the 3-node triangle

/// Corners of the elements of one type, and the coordinates of all nodes.
class Nodes {
 public:
  Nodes() {
    std::vector<std::size_t> tags;
    std::vector<double> x, parameters;
    gmsh::model::mesh::getNodes(tags, x, parameters);
    for (std::size_t k = 0; k < tags.size(); ++k) {
      number_[tags[k]] = k;
      points_.push_back({{x[3 * k], x[3 * k + 1], x[3 * k + 2]}});
    }
  }
  const std::vector<Vec<3>>& points() const { return points_; }
  std::size_t number(std::size_t tag) const { return number_.at(tag); }

 private:
  std::map<std::size_t, std::size_t> number_;
  std::vector<Vec<3>> points_;
};

/// First corners of each element of `dimension` in the mesh, cut to simplices where they are
/// quadrilaterals.
std::vector<std::vector<std::size_t>> elementsOf(int dimension, const std::string& source) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements, nodes, result;
  gmsh::model::mesh::getElements(types, elements, nodes, dimension);
  for (std::size_t k = 0; k < types.size(); ++k) {
    std::string name;
    std::vector<double> unused;
    int d, order, nNodes, nCorners;
    gmsh::model::mesh::getElementProperties(types[k], name, d, order, nNodes, unused, nCorners);
    if (dimension == 3 && nCorners != 4)
      throw InputError(source + ": has volume elements that are no tetrahedra (" + name +
                       "); save the triangles of the surface instead");
    for (std::size_t e = 0; e < elements[k].size(); ++e) {
      const auto begin = nodes[k].begin() + std::ptrdiff_t(e) * nNodes;
      result.emplace_back(begin, begin + nCorners);
    }
  }
  return result;
}

/// The surface of a .msh file: faces of one tetrahedron only, or else its triangles.
TriangleSoup meshSurface(const std::string& source) {
  const Nodes nodes;
  TriangleSoup soup{nodes.points(), {}};
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    soup.triangles.push_back({nodes.number(a), nodes.number(b), nodes.number(c)});
  };
  const auto tetrahedra = elementsOf(3, source);
  std::map<std::array<std::size_t, 3>, int> uses;
  for (const auto& t : tetrahedra)
    for (std::size_t left = 0; left < 4; ++left) {
      std::array<std::size_t, 3> face{t[(left + 1) % 4], t[(left + 2) % 4], t[(left + 3) % 4]};
      std::ranges::sort(face);
      ++uses[face];
    }
  for (const auto& [face, n] : uses)
    if (n == 1) add(face[0], face[1], face[2]);
  if (!tetrahedra.empty()) return soup;
  for (const auto& face : elementsOf(2, source))
    for (std::size_t k = 2; k < face.size(); ++k) add(face[0], face[k - 1], face[k]);
  if (soup.triangles.empty())
    throw InputError(source + ": has no triangles or tetrahedra; save the mesh of the surface");
  return soup;
}

/// The outer surfaces: those that bound the volumes all together, or all if there are no volumes.
std::vector<int> outerSurfaces(const std::string& source) {
  gmsh::vectorpair volumes, surfaces;
  gmsh::model::getEntities(volumes, 3);
  if (volumes.empty())
    gmsh::model::getEntities(surfaces, 2);
  else
    gmsh::model::getBoundary(volumes, surfaces, true, false, false);
  if (surfaces.empty())
    throw InputError(source + ": has neither volumes nor surfaces; export the solid itself");
  std::vector<int> tags;
  for (const auto& [dimension, tag] : surfaces) tags.push_back(std::abs(tag));
  return tags;
}

bool isPlane(int surface) {
  std::string type;
  gmsh::model::getType(2, surface, type);
  return type == "Plane" || type == "Discrete surface";
}

/// The largest radius of curvature of the curved surfaces, sampled [m]; 0 if all are flat.
double largestRadius(const std::vector<int>& surfaces, double size) {
  double largest = 0;
  for (int surface : surfaces) {
    if (isPlane(surface)) continue;
    std::vector<double> lower, upper, where, curvatures;
    gmsh::model::getParametrizationBounds(2, surface, lower, upper);
    for (int i = 1; i < 8; ++i)
      for (int j = 1; j < 8; ++j) {
        where.push_back(lower[0] + i / 8. * (upper[0] - lower[0]));
        where.push_back(lower[1] + j / 8. * (upper[1] - lower[1]));
      }
    gmsh::model::getCurvature(2, surface, where, curvatures);
    for (const double curvature : curvatures)
      if (std::abs(curvature) * size > 0.1) largest = std::max(largest, 1 / std::abs(curvature));
  }
  return largest;
}

/// The largest distance of centres and edge middles of the triangles of `surface` from the surface.
double deviationOf(int surface, const TriangleSoup& soup, std::size_t firstTriangle) {
  if (isPlane(surface)) return 0;
  std::vector<double> x;
  for (std::size_t t = firstTriangle; t < soup.triangles.size(); ++t) {
    const Vec<3> a = soup.corner(t, 0), b = soup.corner(t, 1), c = soup.corner(t, 2);
    for (const Vec<3>& p : {soup.center(t), 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)})
      x.insert(x.end(), p.components.begin(), p.components.end());
  }
  std::vector<double> nearest, parameters;
  gmsh::model::getClosestPoint(2, surface, x, nearest, parameters);
  double largest = 0;
  for (std::size_t k = 0; k + 2 < nearest.size(); k += 3)
    largest = std::max(largest, std::hypot(nearest[k] - x[k], nearest[k + 1] - x[k + 1],
                                           nearest[k + 2] - x[k + 2]));
  return largest;
}

/// Meshes the surfaces with `perCircle` edges on a full circle of any curvature.
CadSurface meshed(const std::vector<int>& surfaces, double perCircle) {
  gmsh::model::mesh::clear();
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", perCircle);
  gmsh::option::setNumber("Mesh.MeshSizeMax", 1e22);
  gmsh::model::mesh::generate(2);
  const Nodes nodes;
  CadSurface result{{nodes.points(), {}}};
  for (int surface : surfaces) {
    const std::size_t first = result.soup.triangles.size();
    std::vector<std::size_t> tags, corners;
    gmsh::model::mesh::getElementsByType(triangle, tags, corners, surface);
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
      result.soup.triangles.push_back(
          {nodes.number(corners[k]), nodes.number(corners[k + 1]), nodes.number(corners[k + 2])});
    result.deviation = std::max(result.deviation, deviationOf(surface, result.soup, first));
  }
  return result;
}

/// Finer and finer until the measured deviation is within the tolerance.
CadSurface meshedWithin(double tolerance, double size, const std::string& source) {
  constexpr int maxTries = 8;
  constexpr std::size_t maxTriangles = 3000000;
  const std::vector<int> surfaces = outerSurfaces(source);
  const double radius = largestRadius(surfaces, size);
  // A chord of a circle is off by radius (1 - cos(pi / n)) in its middle.
  const double share = radius > 0 ? std::min(1., tolerance / radius) : 1;
  double perCircle = std::max(8., std::numbers::pi / std::acos(1 - share));
  for (int attempt = 0; attempt < maxTries; ++attempt) {
    CadSurface surface = meshed(surfaces, perCircle);
    if (surface.deviation <= tolerance) return surface;
    if (surface.soup.triangles.size() > maxTriangles) break;
    perCircle *= std::min(3., 1.05 * std::sqrt(surface.deviation / tolerance));
  }
  throw InputError(
      fmt::format("{}: cannot be meshed within {} triangles to the tolerance {:.3g} m; "
                  "give a larger tolerance",
                  source, maxTriangles, tolerance));
}

}  // namespace

CadSurface readCadSurface(const std::filesystem::path& path, std::optional<double> tolerance,
                          double relativeTolerance) {
  const std::string source = path.string();
  GmshSession session;
  session.open(path);
  CadSurface result;
  session.guarded(source, [&] {
    Vec<3> lower, upper;
    gmsh::model::getBoundingBox(-1, -1, lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
    const double size = norm(upper - lower);
    for (int a = 0; a < 3; ++a)
      if (upper[a] - lower[a] < 1e-6 * size)
        throw InputError(
            fmt::format("{}: is flat (no extent along {}), the case has dimension = 3; "
                        "extrude it to a solid, or set dimension = 2",
                        source, "xyz"[a]));
    const double allowed = tolerance.value_or(relativeTolerance * size);
    if (extensionOf(path) == ".msh")
      result.soup = meshSurface(source);
    else
      result = meshedWithin(allowed, size, source);
    result.tolerance = allowed;
    result.soup = turnedOutwards(welded(result.soup));
  });
  return result;
}

}  // namespace plenum
