// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed triangle meshes of any fineness, for tests and benchmarks.
#pragma once

#include "geometry/triangle_soup.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace plenum {

/// How far the surface is from the origin along a unit vector [m]; positive.
using RadiusAlong = std::function<double(const Vec<3>&)>;

/// A regular icosahedron whose corners are the cyclic permutations of (0, +-1, +-golden).
inline TriangleSoup icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  TriangleSoup soup;
  for (int axis = 0; axis < 3; ++axis)
    for (const double one : {-1.0, 1.0})
      for (const double far : {-golden, golden}) {
        Vec<3> x;
        x[(axis + 1) % 3] = one;
        x[(axis + 2) % 3] = far;
        soup.points.push_back(x);
      }
  const auto neighbours = [&](std::size_t a, std::size_t b) {
    return norm(soup.points[a] - soup.points[b]) < 2.1;  // edges are 2 long, diagonals 3.2
  };
  for (std::size_t a = 0; a < 12; ++a)
    for (std::size_t b = a + 1; b < 12; ++b)
      for (std::size_t c = b + 1; c < 12; ++c) {
        if (!neighbours(a, b) || !neighbours(b, c) || !neighbours(c, a)) continue;
        const bool isLeft =
            dot(soup.points[a], cross(soup.points[b], soup.points[c])) > 0;  // seen from outside
        soup.triangles.push_back({a, isLeft ? b : c, isLeft ? c : b});
      }
  return soup;
}

/// Point (i, j) of a triangle with corners a, b, c whose edges are parted in n; the same bits for
/// both triangles at an edge, because the corners are summed in one order.
inline Vec<3> gridPoint(const TriangleSoup& soup, std::size_t t, int i, int j, int n) {
  struct Share {
    std::size_t corner;
    int parts;
  };
  std::array<Share, 3> shares{
      Share{soup.triangles[t][0], n - i - j}, {soup.triangles[t][1], i}, {soup.triangles[t][2], j}};
  std::ranges::sort(shares, {}, &Share::corner);
  Vec<3> x;
  for (const Share& share : shares)
    x += static_cast<double>(share.parts) * soup.points[share.corner];
  return x / norm(x);
}

/// A closed surface around the origin of 20 `frequency`^2 triangles: an icosahedron whose edges are
/// parted in `frequency`, its points moved out to `radius`.
inline TriangleSoup starShapedMesh(int frequency, const RadiusAlong& radius) {
  const TriangleSoup coarse = icosahedron();
  TriangleSoup soup;
  const auto add = [&](std::size_t t, std::array<std::array<int, 2>, 3> corners) {
    const std::size_t first = soup.points.size();
    for (const auto& [i, j] : corners) {
      const Vec<3> direction = gridPoint(coarse, t, i, j, frequency);
      soup.points.push_back(radius(direction) * direction);
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  };
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t)
    for (int i = 0; i < frequency; ++i)
      for (int j = 0; i + j < frequency; ++j) {
        add(t, {{{i, j}, {i + 1, j}, {i, j + 1}}});
        if (i + j + 1 < frequency) add(t, {{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
      }
  return welded(soup);
}

/// A part of radius 1 m, give or take .25, with humps and hollows of every size down to two
/// triangles of a mesh of `frequency` 100.
inline double roughRadius(const Vec<3>& direction) {
  double radius = 1;
  double height = 0.12;
  Vec<3> wave{{3.1, 4.7, 2.3}};
  for (int octave = 0; octave < 6; ++octave) {
    radius += height * std::sin(wave[0] * direction[0] + octave) *
              std::sin(wave[1] * direction[1] - octave) * std::sin(wave[2] * direction[2] + 0.5);
    height *= 0.5;
    wave *= 2;
  }
  return radius;
}

}  // namespace plenum
