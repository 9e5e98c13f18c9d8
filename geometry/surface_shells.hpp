// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the triangles of a soup hang together: sides, edges, holes, shells.
#pragma once

#include "geometry/triangle_soup.hpp"
#include "particles/box.hpp"

#include <span>

namespace plenum {

/// One side of a triangle, from the smaller to the larger corner.
struct Side {
  std::size_t low;
  std::size_t high;
  std::size_t triangle;
  bool forward;  ///< the triangle runs from low to high

  bool sameEdge(const Side& other) const { return low == other.low && high == other.high; }
};

/// Three sides a triangle, those of one edge next to each other.
std::vector<Side> sidesOf(const TriangleSoup& soup);

/// Calls visit(std::span<const Side>) for each edge with the sides that meet there.
template <class Visit>
void forEachEdge(const std::vector<Side>& sides, Visit&& visit) {
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin;
    while (end < sides.size() && sides[end].sameEdge(sides[begin])) ++end;
    visit(std::span<const Side>(sides).subspan(begin, end - begin));
    begin = end;
  }
}

/// A hole: its corners in the order in which a triangle that closes it has to run.
struct Hole {
  std::vector<std::size_t> corners;
  Vec<3> center{};  ///< mean of the corners [m]
  double size = 0;  ///< diagonal of its bounds [m]
};

/// The closed loops of edges with one triangle only. Where two of them meet in a corner, or where
/// the triangles around are not turned coherently, the open edges are left out.
std::vector<Hole> holesOf(const TriangleSoup& soup, const std::vector<Side>& sides);

/// A part of the surface that hangs together.
struct Shell {
  const TriangleSoup& whole;
  std::vector<std::size_t> triangles;
  Box<3> bounds = Box<3>::nothing();

  void add(std::size_t triangle);

  /// A point of it [m].
  Vec<3> somewhere() const { return whole.center(triangles.front()); }

  double signedVolume() const;  ///< [m^3]

  /// By the angle under which its triangles are seen from `x`: a full sphere inside, none outside.
  /// van Oosterom & Strackee (1983), doi 10.1109/TBME.1983.325207.
  bool contains(const Vec<3>& x) const;
};

std::vector<Shell> shellsOf(const TriangleSoup& soup, const std::vector<Side>& sides);

/// The numbers of the other shells in which shell `k` lies.
std::vector<std::size_t> shellsAround(std::size_t k, const std::vector<Shell>& shells);

}  // namespace plenum
