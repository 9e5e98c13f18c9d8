// SPDX-License-Identifier: GPL-3.0-or-later
//
// One of the sources that see CGAL.
#include "geometry/voronoi_facets.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace plenum {

namespace {

using Index = std::uint32_t;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;

using Delaunay2 = CGAL::Delaunay_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>,
                                         CGAL::Triangulation_face_base_with_info_2<Index, Kernel>>>;
using Delaunay3 = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<
                CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>,
                CGAL::Triangulation_cell_base_with_info_3<
                    Index, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>>;

constexpr Index unknown = std::numeric_limits<Index>::max();

/// A simplex of less than this part of the product of its edges is a sliver, as they come by the
/// dozen in perfect lattices: doubles would lose its centre, which is then computed exactly. Above,
/// the centre is right to about round-off over this number: 2e-13 edges.
constexpr double sliver = 1e-3;

Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

Vec<2> toVec(const Kernel::Point_2& p) { return {{p.x(), p.y()}}; }
Vec<3> toVec(const Kernel::Point_3& p) { return {{p.x(), p.y(), p.z()}}; }

Vec<2> exactCentre(const std::array<Vec<2>, 3>& p) {
  const auto exact = [](const Vec<2>& x) { return Rational::Point_2(x[0], x[1]); };
  const auto c = CGAL::circumcenter(exact(p[0]), exact(p[1]), exact(p[2]));
  return {{CGAL::to_double(c.x()), CGAL::to_double(c.y())}};
}

Vec<3> exactCentre(const std::array<Vec<3>, 4>& p) {
  const auto exact = [](const Vec<3>& x) { return Rational::Point_3(x[0], x[1], x[2]); };
  const auto c = CGAL::circumcenter(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]));
  return {{CGAL::to_double(c.x()), CGAL::to_double(c.y()), CGAL::to_double(c.z())}};
}

/// Centre of the sphere through the corners of a simplex.
Vec<2> centre(const std::array<Vec<2>, 3>& p) {
  const Vec<2> a = p[1] - p[0], b = p[2] - p[0];
  const double aa = normSquared(a), bb = normSquared(b);
  const double area = a[0] * b[1] - a[1] * b[0];
  if (std::abs(area) < sliver * std::sqrt(aa * bb)) return exactCentre(p);
  return p[0] + Vec<2>{{aa * b[1] - bb * a[1], bb * a[0] - aa * b[0]}} / (2 * area);
}

Vec<3> centre(const std::array<Vec<3>, 4>& p) {
  const Vec<3> a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const double aa = normSquared(a), bb = normSquared(b), cc = normSquared(c);
  const Vec<3> bc = cross(b, c);
  const double volume = dot(a, bc);
  if (std::abs(volume) < sliver * std::sqrt(aa * bb * cc)) return exactCentre(p);
  return p[0] + (aa * bc + bb * cross(c, a) + cc * cross(a, b)) / (2 * volume);
}

/// Gives every simplex that has one of the first n points its number and corner. In the order of
/// the simplices: that of edges depends on where in memory things lie, and would let the last bits
/// of sums change from call to call.
template <int Dim, class Simplices>
void addCorners(Simplices&& simplices, std::size_t n, VoronoiFacets<Dim>& result) {
  for (const auto& simplex : simplices) {
    std::array<Vec<Dim>, Dim + 1> p;
    bool wanted = false;
    for (int k = 0; k <= Dim; ++k) {
      p[static_cast<std::size_t>(k)] = toVec(simplex->vertex(k)->point());
      wanted = wanted || simplex->vertex(k)->info() < n;
    }
    if (!wanted) continue;
    simplex->info() = static_cast<Index>(result.corners.size());
    result.corners.push_back(centre(p));
  }
}

/// Lets the corners of the last facet begin with the least number and go on to its lesser
/// neighbour.
template <int Dim>
void orderCorners(VoronoiFacets<Dim>& result) {
  const auto begin =
      result.cornersInTurn.begin() + static_cast<std::ptrdiff_t>(result.facets.back().firstCorner);
  const auto end = result.cornersInTurn.end();
  std::rotate(begin, std::min_element(begin, end), end);
  if (*(begin + 1) > *(end - 1)) std::reverse(begin + 1, end);
}

/// Inserted along a space-filling curve, as CGAL does with points that carry a number.
template <class Delaunay, int Dim>
Delaunay triangulated(std::span<const Vec<Dim>> points) {
  std::vector<std::pair<typename Delaunay::Point, Index>> numbered(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec<Dim>& x = points[i];
    if constexpr (Dim == 2)
      numbered[i] = {{x[0], x[1]}, static_cast<Index>(i)};
    else
      numbered[i] = {{x[0], x[1], x[2]}, static_cast<Index>(i)};
  }
  Delaunay delaunay;
  delaunay.insert(numbered.begin(), numbered.end());
  return delaunay;
}

/// Returns whether all n cells are bounded.
bool addFacets(std::span<const Vec<2>> points, std::size_t n, VoronoiFacets<2>& result) {
  const Delaunay2 delaunay = triangulated<Delaunay2>(points);
  if (delaunay.dimension() < 2) return false;
  addCorners(delaunay.finite_face_handles(), n, result);
  for (const auto& [face, k] : delaunay.finite_edges()) {
    const Index a = face->vertex(Delaunay2::ccw(k))->info();
    const Index b = face->vertex(Delaunay2::cw(k))->info();
    if (a >= n && b >= n) continue;
    const auto other = face->neighbor(k);
    if (delaunay.is_infinite(face) || delaunay.is_infinite(other)) return false;
    result.facets.push_back({a, b, result.cornersInTurn.size()});
    result.cornersInTurn.push_back(face->info());
    result.cornersInTurn.push_back(other->info());
    orderCorners(result);
  }
  return true;
}

bool addFacets(std::span<const Vec<3>> points, std::size_t n, VoronoiFacets<3>& result) {
  const Delaunay3 delaunay = triangulated<Delaunay3>(points);
  if (delaunay.dimension() < 3) return false;
  addCorners(delaunay.finite_cell_handles(), n, result);
  for (const auto& edge : delaunay.finite_edges()) {
    const Index a = edge.first->vertex(edge.second)->info();
    const Index b = edge.first->vertex(edge.third)->info();
    if (a >= n && b >= n) continue;
    result.facets.push_back({a, b, result.cornersInTurn.size()});
    const auto first = delaunay.incident_cells(edge);
    auto around = first;
    do {
      if (delaunay.is_infinite(around)) return false;
      const Delaunay3::Cell_handle cell = around;
      result.cornersInTurn.push_back(cell->info());
    } while (++around != first);
    orderCorners(result);
  }
  return true;
}

/// On a line, cells meet in the middle between neighbours.
bool addFacets(std::span<const Vec<1>> points, std::size_t n, VoronoiFacets<1>& result) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](Index i) { return std::pair(points[i][0], i); });
  if (order.front() < n || order.back() < n) return false;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const Index a = order[k], b = order[k + 1];
    if (a >= n && b >= n) continue;
    result.facets.push_back({a, b, result.cornersInTurn.size()});
    result.cornersInTurn.push_back(static_cast<Index>(result.corners.size()));
    result.corners.push_back(0.5 * (points[a] + points[b]));
  }
  return true;
}

}  // namespace

template <int Dim>
VoronoiFacets<Dim> voronoiFacets(std::span<const Vec<Dim>> points, std::size_t n) {
  if (n > points.size() || points.size() >= unknown)
    throw std::invalid_argument("voronoiFacets: asked for more cells than there are points");
  for (const Vec<Dim>& x : points)
    if (!std::isfinite(normSquared(x)))
      throw std::invalid_argument("voronoiFacets: a point is not finite");
  VoronoiFacets<Dim> result;
  if (n > 0) result.isBounded = addFacets(points, n, result);
  return result;
}

template VoronoiFacets<1> voronoiFacets(std::span<const Vec<1>>, std::size_t);
template VoronoiFacets<2> voronoiFacets(std::span<const Vec<2>>, std::size_t);
template VoronoiFacets<3> voronoiFacets(std::span<const Vec<3>>, std::size_t);

}  // namespace plenum
