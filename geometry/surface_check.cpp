// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_check.hpp"

#include "geometry/print.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// Things of one kind: how many, and where the first is.
struct Fault {
  std::size_t n = 0;
  Vec<3> at{};

  void add(const Vec<3>& x) {
    if (n++ == 0) at = x;
  }
};

void addFlatTriangles(const TriangleSoup& soup, const std::string& source,
                      std::vector<Finding>& faults) {
  Fault flat;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (hasNoArea(soup, t)) flat.add(soup.center(t));
  if (flat.n == 0) return;
  faults.push_back({Severity::error,
                    fmt::format("{}: {} triangle{} no area, the first at {}", source, flat.n,
                                flat.n == 1 ? " has" : "s have", printed(flat.at)),
                    "remove degenerate faces in the meshing tool and export again",
                    placeOf(flat.at)});
}

void addEdges(const TriangleSoup& soup, const std::vector<Side>& sides, const std::string& source,
              std::vector<Finding>& faults) {
  Fault open, crowded, turned;
  forEachEdge(sides, [&](std::span<const Side> edge) {
    const Vec<3> middle = 0.5 * (soup.points[edge[0].low] + soup.points[edge[0].high]);
    if (edge.size() == 1) open.add(middle);
    if (edge.size() > 2) crowded.add(middle);
    if (edge.size() == 2 && edge[0].forward == edge[1].forward) turned.add(middle);
  });
  const auto report = [&](const Fault& fault, const std::string& what, const std::string& more,
                          const std::string& remedy) {
    if (fault.n > 0)
      faults.push_back({Severity::error,
                        fmt::format("{}: {}: {} such edge{}, the first at {}{}", source, what,
                                    fault.n, fault.n == 1 ? "" : "s", printed(fault.at), more),
                        remedy, placeOf(fault.at)});
  };
  const std::string holes = open.n > 0 ? describeHoles(holesOf(soup, sides)) : "";
  report(open, "the surface is not closed (edges with a triangle on one side only)",
         holes.empty() ? "" : ", " + holes,
         "close the holes in the meshing tool, have small ones closed with mend = { holes = true } "
         "beside file, or give a thickness there if it is meant as a thin wall");
  report(crowded, "the surface is not one sheet (edges with more than two triangles)", "",
         "remove double or inner faces in the meshing tool, or part bodies that touch along an "
         "edge");
  report(turned, "neighbouring triangles are turned against each other", "",
         "orient all faces coherently in the meshing tool");
}

void addOrientation(const TriangleSoup& soup, const std::vector<Side>& sides,
                    const std::string& source, std::vector<Finding>& faults) {
  const std::vector<Shell> shells = shellsOf(soup, sides);
  for (std::size_t k = 0; k < shells.size(); ++k) {
    const Vec<3> seenAt = shells[k].somewhere();
    const bool isCavity = shellsAround(k, shells).size() % 2 == 1;
    const double volume = shells[k].signedVolume();
    if (!isCavity && volume < 0)
      faults.push_back(
          {Severity::error,
           fmt::format("{}: the surface{} is inside out (its triangles run clockwise seen from "
                       "outside, volume {:.6g} m^3), seen at {}",
                       source, shells.size() > 1 ? " of one part" : "", volume, printed(seenAt)),
           "flip its normals in the meshing tool", placeOf(seenAt)});
    if (isCavity && volume > 0)
      faults.push_back(
          {Severity::error,
           fmt::format("{}: a part at {} lies inside another one", source, printed(seenAt)),
           "flip its normals if it is a cavity, remove it if not", placeOf(seenAt)});
  }
}

}  // namespace

void checkFinite(const TriangleSoup& soup, const std::string& source) {
  for (std::size_t k = 0; k < soup.points.size(); ++k) {
    if (std::isfinite(norm(soup.points[k]))) continue;
    const auto triangle = std::ranges::find_if(
        soup.triangles, [&](const auto& t) { return std::ranges::find(t, k) != t.end(); });
    const std::string of = triangle == soup.triangles.end()
                               ? ""
                               : fmt::format(" of triangle {}", triangle - soup.triangles.begin());
    throw InputError(fmt::format(
        "{}: a corner is not finite: {}, number {}{} (counted from 0); coordinates must "
        "be numbers, export it again",
        source, printed(soup.points[k]), k, of));
  }
}

std::string describeHoles(const std::vector<Hole>& holes) {
  if (holes.empty()) return "";
  const Hole& largest = *std::ranges::max_element(holes, {}, &Hole::size);
  return fmt::format("{} hole{} {:.4g} m across, at {}", holes.size(),
                     holes.size() == 1 ? "," : "s, the largest", largest.size,
                     printed(largest.center));
}

std::vector<Finding> surfaceFaults(const TriangleSoup& soup, const std::string& source) {
  if (soup.triangles.empty())
    return {{Severity::error, source + ": holds no triangles", "export a closed surface mesh", {}}};
  std::vector<Finding> faults;
  addFlatTriangles(soup, source, faults);
  const std::vector<Side> sides = sidesOf(soup);
  addEdges(soup, sides, source, faults);
  if (faults.empty()) addOrientation(soup, sides, source, faults);
  return faults;
}

}  // namespace plenum
