// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"
#include "particles/vec.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace plenum {

/// Triangles as a file has them; corners counter-clockwise seen from outside.
struct TriangleSoup {
  std::vector<Vec<3>> points;  ///< [m]
  std::vector<std::array<std::size_t, 3>> triangles;

  Vec<3> corner(std::size_t triangle, std::size_t k) const {
    return points[triangles[triangle][k]];
  }
  Vec<3> center(std::size_t triangle) const {
    return (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2)) / 3;
  }
};

constexpr Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

Box<3> boundsOf(const TriangleSoup& soup);

/// True if the triangle's height is below 1e-12 of its longest side.
bool hasNoArea(const TriangleSoup& soup, std::size_t triangle);

/// Six times the signed volume of the tetrahedron of a triangle and `origin` [m^3].
double sixfoldVolume(const TriangleSoup& soup, std::size_t triangle, const Vec<3>& origin);

/// Volume by the divergence theorem [m^3], negative if the surface is inside out.
double signedVolume(const TriangleSoup& soup);

/// For each point the first of those within `near` [m] of it, which may be itself.
std::vector<std::size_t> mergedPoints(const std::vector<Vec<3>>& points, double near);

/// Corners that are not further apart are one: 1e-9 of the size [m].
double weldingDistance(const TriangleSoup& soup);

/// Corners nearer than `weldingDistance` become one (STL repeats them for each triangle); triangles
/// that collapse by it and corners of no triangle are dropped.
TriangleSoup welded(const TriangleSoup& soup);

}  // namespace plenum
