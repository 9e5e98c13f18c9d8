// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faults of a triangle mesh that can be taken out without a guess at what was meant.
#pragma once

#include "geometry/triangle_soup.hpp"
#include "particles/findings.hpp"

#include <string>

namespace plenum {

/// What is mended only on request.
struct MendOptions {
  bool holes = false;
  double largestHole = defaultLargestHole;  ///< diagonal of its bounds over that of the part's

  static constexpr double defaultLargestHole = 0.05;
};

/// The welded soup, mended; each kind of mending is reported as a note that says how much was done
/// and where.
///
/// - Corners that repeat, or lie within `weldingDistance` of each other, become one. (STL repeats
///   every corner: no word about that.)
/// - A triangle without area goes: its long side is given to its neighbour there, or it is left out
///   where it hangs on one edge only or closes a slit of no width.
/// - Triangles that are turned against most of their part are turned; a part that is inside out is
///   turned as a whole, with what lies inside of it.
/// - On request, holes: each is closed with triangles from the mean of its corners, unless it is
///   larger than `largestHole`.
///
/// Whatever it does not mend (more than two triangles on an edge, one part inside another, ...) it
/// leaves for `surfaceFaults` to find. `soup` must be finite; `source` begins every message.
TriangleSoup mended(const TriangleSoup& soup, const MendOptions& options, const std::string& source,
                    const FindingSink& report);

/// The welded soup with its triangles turned coherently and outwards (inwards in cavities), as far
/// as it is closed: for meshes from CAD, where the order of corners says nothing.
TriangleSoup turnedOutwards(TriangleSoup soup);

// The steps of `mended`, each on a welded soup.

/// Takes out triangles without area; returns where each was [m].
std::vector<Vec<3>> removeFlatTriangles(TriangleSoup& soup);

/// Turns triangles so that neighbours agree; the smaller number of each part is turned. Returns
/// where they were [m]. Does nothing if some edge has more than two triangles or there is only one
/// side.
std::vector<Vec<3>> turnCoherently(TriangleSoup& soup);

/// Turns outermost parts that are inside out, with all that lies in them. The soup must be closed
/// and coherent. Returns a point of each part [m].
std::vector<Vec<3>> turnPartsOutwards(TriangleSoup& soup);

}  // namespace plenum
