// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mend_surface.hpp"

#include "geometry/print.hpp"
#include "geometry/surface_check.hpp"
#include "geometry/surface_shells.hpp"

#include <algorithm>

namespace plenum {

namespace {

/// Whether the soup has three corners of its own for each triangle, as STL files do.
bool repeatsCorners(const TriangleSoup& soup) {
  if (soup.points.size() != 3 * soup.triangles.size()) return false;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (soup.triangles[t][k] != 3 * t + k) return false;
  return true;
}

/// Where corners were joined that a file has no reason to repeat.
std::vector<Vec<3>> joinedCorners(const TriangleSoup& soup) {
  const auto mergedWith = mergedPoints(soup.points, weldingDistance(soup));
  const bool isStl = repeatsCorners(soup);
  std::vector<Vec<3>> places;
  for (std::size_t k = 0; k < soup.points.size(); ++k) {
    if (mergedWith[k] == k) continue;
    if (!isStl || soup.points[k] != soup.points[mergedWith[k]]) places.push_back(soup.points[k]);
  }
  return places;
}

std::string printedCount(std::size_t n, const std::string& what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? " was" : "s were");
}

void say(const FindingSink& report, const std::string& source, const std::vector<Vec<3>>& places,
         const std::string& what, const std::string& done, const std::string& remedy) {
  if (places.empty()) return;
  report({Severity::note,
          fmt::format("{}: mended: {} {}, the first at {}", source,
                      printedCount(places.size(), what), done, printed(places.front())),
          remedy, placeOf(places.front())});
}

/// Closes small holes; returns those that were closed.
std::vector<Hole> closeHoles(TriangleSoup& soup, double largest) {
  std::vector<Hole> closed;
  const double allowed = largest * norm(boundsOf(soup).extent());
  for (Hole& hole : holesOf(soup, sidesOf(soup))) {
    if (hole.size > allowed) continue;
    const std::size_t n = hole.corners.size();
    if (n == 3) {
      soup.triangles.push_back({hole.corners[0], hole.corners[1], hole.corners[2]});
    } else {
      const std::size_t middle = soup.points.size();
      soup.points.push_back(hole.center);
      for (std::size_t k = 0; k < n; ++k)
        soup.triangles.push_back({hole.corners[k], hole.corners[(k + 1) % n], middle});
    }
    closed.push_back(std::move(hole));
  }
  return closed;
}

bool isClosedAndCoherent(const TriangleSoup& soup) {
  bool result = true;
  forEachEdge(sidesOf(soup), [&](std::span<const Side> edge) {
    if (edge.size() != 2 || edge[0].forward == edge[1].forward) result = false;
  });
  return result;
}

}  // namespace

TriangleSoup mended(const TriangleSoup& soup, const MendOptions& options, const std::string& source,
                    const FindingSink& report) {
  TriangleSoup result = welded(soup);
  say(report, source, joinedCorners(soup), "corner", "joined with others in the same place",
      "nothing needs to be done");
  std::vector<Vec<3>> flat = removeFlatTriangles(result);
  std::size_t nCollapsed = soup.triangles.size() - welded(soup).triangles.size();
  if (nCollapsed > 0)
    report({Severity::note,
            fmt::format("{}: mended: {} left out whose corners coincide", source,
                        printedCount(nCollapsed, "triangle")),
            "nothing needs to be done",
            {}});
  say(report, source, flat, "triangle", "taken out that had no area",
      "look at the picture of the particles there");
  say(report, source, turnCoherently(result), "triangle", "turned to agree with the others",
      "orient all faces in the meshing tool to be sure");
  if (options.holes) {
    const std::vector<Hole> closed = closeHoles(result, options.largestHole);
    if (!closed.empty())
      report({Severity::note, fmt::format("{}: mended: closed {}", source, describeHoles(closed)),
              "look at the picture of the particles there", placeOf(closed.front().center)});
  }
  if (isClosedAndCoherent(result))
    say(report, source, turnPartsOutwards(result), "part", "inside out and turned outside in",
        "export with normals that point outwards to be sure");
  return result;
}

std::vector<Vec<3>> turnPartsOutwards(TriangleSoup& soup) {
  std::vector<Vec<3>> places;
  std::vector<bool> turned(soup.triangles.size(), false);
  const std::vector<Shell> shells = shellsOf(soup, sidesOf(soup));
  std::vector<std::vector<std::size_t>> around;
  for (std::size_t k = 0; k < shells.size(); ++k) around.push_back(shellsAround(k, shells));
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (!around[k].empty() || !(shells[k].signedVolume() < 0)) continue;
    places.push_back(shells[k].somewhere());
    for (std::size_t other = 0; other < shells.size(); ++other)
      if (other == k || std::ranges::find(around[other], k) != around[other].end())
        for (std::size_t t : shells[other].triangles) turned[t] = true;
  }
  for (std::size_t t = 0; t < turned.size(); ++t)
    if (turned[t]) std::swap(soup.triangles[t][1], soup.triangles[t][2]);
  return places;
}

TriangleSoup turnedOutwards(TriangleSoup soup) {
  turnCoherently(soup);
  std::vector<bool> turned(soup.triangles.size(), false);
  const std::vector<Shell> shells = shellsOf(soup, sidesOf(soup));
  for (std::size_t k = 0; k < shells.size(); ++k) {
    const bool isCavity = shellsAround(k, shells).size() % 2 == 1;
    if ((shells[k].signedVolume() < 0) != isCavity)
      for (std::size_t t : shells[k].triangles) turned[t] = true;
  }
  for (std::size_t t = 0; t < turned.size(); ++t)
    if (turned[t]) std::swap(soup.triangles[t][1], soup.triangles[t][2]);
  return soup;
}

}  // namespace plenum
