// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where neighbouring Voronoi cells touch, from the Delaunay triangulation of their generators.
#pragma once

#include "particles/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace plenum {

/// The facets between the cells of pairs of generators: a point in one dimension, a segment in two,
/// a convex polygon in three.
template <int Dim>
struct VoronoiFacets {
  struct Facet {
    std::uint32_t a, b;       ///< the two generators
    std::size_t firstCorner;  ///< in cornersInTurn; the next facet's first corner ends it
  };

  std::vector<Vec<Dim>> corners;             ///< centres of circumscribed spheres [m]
  std::vector<std::uint32_t> cornersInTurn;  ///< facet by facet, around it
  std::vector<Facet> facets;
  bool isBounded = true;  ///< else a cell reaches infinity, and what is here is not all

  /// Corners of facet `f`, as indices into `corners`.
  std::span<const std::uint32_t> cornersOf(std::size_t f) const {
    const std::size_t first = facets[f].firstCorner;
    const std::size_t last =
        f + 1 < facets.size() ? facets[f + 1].firstCorner : cornersInTurn.size();
    return std::span(cornersInTurn).subspan(first, last - first);
  }
};

/// Facets of the cells of the first `n` points [m]; the other points bound these cells. Every facet
/// comes once, whether one or both of its generators are among the first n. Where more than Dim + 1
/// points lie on an empty sphere, corners coincide up to round-off and facets of no area appear.
/// Of points at the same place one has the cell. Throws std::invalid_argument for n >
/// points.size(), for more than 2^32 - 2 points, and for a point that is not finite.
template <int Dim>
VoronoiFacets<Dim> voronoiFacets(std::span<const Vec<Dim>> points, std::size_t n);

}  // namespace plenum
