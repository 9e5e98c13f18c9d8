// SPDX-License-Identifier: GPL-3.0-or-later
//
// One of the sources that see CGAL.
#include "geometry/surface_mesh.hpp"

#include "geometry/print.hpp"
#include "geometry/surface_check.hpp"
#include "geometry/triangle_rows.hpp"
#include "particles/errors.hpp"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace plenum {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

Kernel::Point_3 toPoint(const Vec<3>& x) { return {x[0], x[1], x[2]}; }
Vec<3> toVec(const Kernel::Point_3& x) { return {{x.x(), x.y(), x.z()}}; }

/// Faces of the mesh are numbered as the triangles of the soup.
Mesh toMesh(const TriangleSoup& soup, const std::string& source) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Vec<3>& x : soup.points) vertices.push_back(mesh.add_vertex(toPoint(x)));
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto& [a, b, c] = soup.triangles[t];
    if (mesh.add_face(vertices[a], vertices[b], vertices[c]) == Mesh::null_face())
      throw FaultyInput({{Severity::error,
                          fmt::format("{}: the surface touches itself in a point near {}", source,
                                      printed(soup.center(t))),
                          "part it there in the meshing tool", placeOf(soup.center(t))}});
  }
  return mesh;
}

void checkSelfIntersections(const Mesh& mesh, const TriangleSoup& soup, const std::string& source) {
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  if (pairs.empty()) return;
  const Vec<3> first = soup.center(std::size_t(pairs.front().first));
  throw FaultyInput(
      {{Severity::error,
        fmt::format("{}: the surface crosses itself: {} pair{} of triangles, the "
                    "first near {}",
                    source, pairs.size(), pairs.size() == 1 ? "" : "s", printed(first)),
        "mend it in the meshing tool or join its parts with a boolean union there",
        placeOf(first)}});
}

/// Normals that give the right side wherever on the surface the nearest point lies: of faces, of
/// edges (mean of both faces) and of corners (mean weighted with the angles). Baerentzen & Aanaes
/// (2005), doi 10.1109/TVCG.2005.49.
class PseudoNormals {
 public:
  PseudoNormals(const TriangleSoup& soup, const Mesh& mesh) : corners_(soup.points.size()) {
    faces_.reserve(soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
      const Vec<3> area =
          cross(soup.corner(t, 1) - soup.corner(t, 0), soup.corner(t, 2) - soup.corner(t, 0));
      faces_.push_back(area / norm(area));
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec<3> u = soup.corner(t, (k + 1) % 3) - soup.corner(t, k);
        const Vec<3> v = soup.corner(t, (k + 2) % 3) - soup.corner(t, k);
        corners_[soup.triangles[t][k]] += std::atan2(norm(cross(u, v)), dot(u, v)) * faces_[t];
      }
    }
    beyond_.resize(soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto corner = [&](std::size_t c) {
          return Mesh::Vertex_index(static_cast<Mesh::size_type>(soup.triangles[t][c % 3]));
        };
        const auto side = mesh.halfedge(corner(k), corner(k + 1));
        beyond_[t][k] = static_cast<std::uint32_t>(mesh.face(mesh.opposite(side)));
      }
  }

  const Vec<3>& face(std::size_t t) const { return faces_[t]; }
  /// Of the edge from corner k of triangle t to the next.
  Vec<3> edge(std::size_t t, std::size_t k) const { return faces_[t] + faces_[beyond_[t][k]]; }
  const Vec<3>& corner(std::size_t point) const { return corners_[point]; }

 private:
  std::vector<Vec<3>> faces_;
  std::vector<std::array<std::uint32_t, 3>> beyond_;  ///< the triangle on the other side
  std::vector<Vec<3>> corners_;
};

/// All that exact questions need.
class ExactSurface {
 public:
  ExactSurface(const TriangleSoup& soup, const Mesh& mesh)
      : normals(soup, mesh), tree(faces(mesh).begin(), faces(mesh).end(), mesh) {
    tree.build();
    tree.accelerate_distance_queries();  // now, so that queries only read
    side = std::make_unique<CGAL::Side_of_triangle_mesh<Mesh, Kernel>>(tree);
  }

  PseudoNormals normals;
  Tree tree;
  std::unique_ptr<CGAL::Side_of_triangle_mesh<Mesh, Kernel>> side;
};

class SurfaceMesh final : public Geometry<3> {
 public:
  using Geometry<3>::closest;

  SurfaceMesh(TriangleSoup soup, Mesh mesh, std::string description, double tolerance)
      : soup_(std::move(soup)),
        mesh_(std::move(mesh)),
        description_(std::move(description)),
        tolerance_(tolerance),
        volume_(signedVolume(soup_)) {
    for (const Vec<3>& x : soup_.points) bounds_.extend(x);
    size_ = std::max(norm(bounds_.lower), norm(bounds_.upper));
  }

  void closest(std::span<const Vec<3>> points, std::span<SurfacePoint<3>> result) const override {
    const ExactSurface& surface = exact();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto hit = surface.tree.closest_point_and_primitive(toPoint(points[k]));
      result[k] = onTriangle(surface, std::size_t(hit.second), toVec(hit.first), points[k]);
    }
  }

  std::unique_ptr<const RowClassifier<3>> rowClassifier(const Vec<3>& step,
                                                        double near) const override {
    return classifierOfTriangles(soup_, step, near);
  }

  Box<3> bounds() const override { return bounds_; }
  Measure volume() const override { return {volume_, 0}; }
  double tolerance() const override { return tolerance_; }
  std::string describe() const override {
    return fmt::format("surface of {} triangles ({})", soup_.triangles.size(), description_);
  }

 private:
  /// Built when it is first needed: filling asks rows first, and exactly only at the surface.
  const ExactSurface& exact() const {
    std::call_once(isBuilt_, [this] { exact_.emplace(soup_, mesh_); });
    return *exact_;
  }

  /// `nearest` on triangle t, seen from x.
  SurfacePoint<3> onTriangle(const ExactSurface& surface, std::size_t t, const Vec<3>& nearest,
                             const Vec<3>& x) const {
    bool onFace = false;
    const Vec<3> normal = normalAt(surface.normals, t, nearest, onFace);
    const Vec<3> way = x - nearest;
    const double distance = norm(way);
    const double along = dot(way, normal);
    if (distance <= 1e-14 * size_) return {nearest, normal, 0};

    // The pseudo-normal decides unless x lies almost in the tangent plane of a sharp edge or so
    // near that round-off matters; then exact rays do.
    double sign = along < 0 ? -1 : 1;
    if (std::abs(along) < 1e-6 * distance || distance < 1e-9 * size_) {
      const CGAL::Bounded_side side = (*surface.side)(toPoint(x));
      if (side == CGAL::ON_BOUNDARY) return {nearest, normal, 0};
      sign = side == CGAL::ON_BOUNDED_SIDE ? -1 : 1;
    }
    if (!onFace) return {nearest, sign / distance * way, sign * distance};
    const double height = sign * std::abs(dot(x - soup_.corner(t, 0), normal));
    return {x - height * normal, normal, height};
  }

  /// The unit pseudo-normal of the face, edge or corner on which p lies.
  Vec<3> normalAt(const PseudoNormals& normals, std::size_t t, const Vec<3>& p,
                  bool& onFace) const {
    std::array<bool, 3> onEdge{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec<3> from = soup_.corner(t, k);
      const Vec<3> along = soup_.corner(t, (k + 1) % 3) - from;
      const double height = dot(cross(normals.face(t), along), p - from) / norm(along);
      onEdge[k] = height < 1e-10 * size_;
    }
    onFace = false;
    Vec<3> normal = normals.face(t);
    for (std::size_t k = 0; k < 3; ++k) {
      if (onEdge[k] && onEdge[(k + 2) % 3]) {
        normal = normals.corner(soup_.triangles[t][k]);
        return normal / norm(normal);
      }
      if (onEdge[k]) normal = normals.edge(t, k);
    }
    onFace = !(onEdge[0] || onEdge[1] || onEdge[2]);
    return normal / norm(normal);
  }

  TriangleSoup soup_;
  Mesh mesh_;
  mutable std::once_flag isBuilt_;
  mutable std::optional<ExactSurface> exact_;
  Box<3> bounds_ = Box<3>::nothing();
  std::string description_;
  double tolerance_;
  double volume_;
  double size_ = 0;
};

}  // namespace

GeometryPtr<3> makeSurfaceMesh(const TriangleSoup& soup, const std::string& source,
                               double tolerance) {
  checkFinite(soup, source);
  TriangleSoup clean = welded(soup);
  std::vector<Finding> faults = surfaceFaults(clean, source);
  if (!faults.empty()) throw FaultyInput(std::move(faults));
  Mesh mesh = toMesh(clean, source);
  checkSelfIntersections(mesh, clean, source);
  return std::make_shared<const SurfaceMesh>(std::move(clean), std::move(mesh), source, tolerance);
}

}  // namespace plenum
