// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/print.hpp"
#include "geometry/surface_check.hpp"
#include "geometry/thicken.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

Vec<3> areaOf(const TriangleSoup& soup, std::size_t t) {
  return cross(soup.corner(t, 1) - soup.corner(t, 0), soup.corner(t, 2) - soup.corner(t, 0));
}

[[noreturn]] void fail(const std::string& what, const std::string& remedy, const Vec<3>& place) {
  throw FaultyInput({{Severity::error, what, remedy, placeOf(place)}});
}

/// Open, one sheet, two sides.
void checkIsOpenSheet(const TriangleSoup& soup, const std::string& source) {
  const std::vector<Side> sides = sidesOf(soup);
  std::vector<bool> isOpen(soup.triangles.size(), false);  // of the triangles at the rim
  forEachEdge(sides, [&](std::span<const Side> edge) {
    const Vec<3> middle = 0.5 * (soup.points[edge[0].low] + soup.points[edge[0].high]);
    if (edge.size() > 2)
      fail(fmt::format("{}: the surface is not one sheet at {} (an edge with {} triangles)", source,
                       printed(middle), edge.size()),
           "thicken the sheets one by one, from files of their own, and join them with union",
           middle);
    if (edge.size() == 2 && edge[0].forward == edge[1].forward)
      fail(fmt::format("{}: the surface has only one side, as a Moebius strip has (neighbours are "
                       "turned against each other at {} whichever way they are turned)",
                       source, printed(middle)),
           "cut it open there, or model the wall as a closed surface", middle);
    if (edge.size() == 1) isOpen[edge[0].triangle] = true;
  });
  for (const Shell& shell : shellsOf(soup, sides))
    if (std::ranges::none_of(shell.triangles, [&](std::size_t t) { return isOpen[t]; }))
      fail(fmt::format("{}: the surface{} is closed, seen at {}, and thickness is for open ones",
                       source, shell.triangles.size() < soup.triangles.size() ? " of one part" : "",
                       printed(shell.somewhere())),
           "remove thickness to have the region inside it; for a hollow shell take the difference "
           "of two such regions",
           shell.somewhere());
}

/// The normals at one corner, those of one plane as one, and how much of the angle around the
/// corner each has.
struct Fan {
  std::vector<Vec<3>> normals;
  std::vector<double> angles;

  void add(const Vec<3>& normal, double angle) {
    for (std::size_t k = 0; k < normals.size(); ++k)
      if (norm(normals[k] - normal) < 1e-9) {
        angles[k] += angle;
        return;
      }
    normals.push_back(normal);
    angles.push_back(angle);
  }

  /// The shortest m with m . n = 1 for every normal; where there is none, by least squares.
  Vec<3> mitre() const;

  /// How far the thickness may be off with shift m.
  double error(const Vec<3>& m) const {
    double largest = 0;
    for (const Vec<3>& n : normals) largest = std::max(largest, std::abs(dot(n, m) - 1));
    return largest;
  }
};

/// Conjugate gradients on sum of angle n (n . m - 1) = 0 from m = 0: in three dimensions they end
/// after three steps, with the shortest solution.
Vec<3> Fan::mitre() const {
  const auto apply = [&](const Vec<3>& m) {
    Vec<3> sum;
    for (std::size_t k = 0; k < normals.size(); ++k)
      sum += angles[k] * dot(normals[k], m) * normals[k];
    return sum;
  };
  Vec<3> m, residual;
  for (std::size_t k = 0; k < normals.size(); ++k) residual += angles[k] * normals[k];
  const double first = normSquared(residual);
  Vec<3> way = residual;
  // What is left below 1e-14 is round-off, which must not be blown up where faces are almost flat.
  for (int step = 0; step < 12 && normSquared(residual) > 1e-28 * first; ++step) {
    const Vec<3> image = apply(way);
    const double curvature = dot(way, image);
    if (!(curvature > 0)) break;
    const double squared = normSquared(residual);
    m += squared / curvature * way;
    residual -= squared / curvature * image;
    way = residual + normSquared(residual) / squared * way;
  }
  return m;
}

std::vector<Vec<3>> mitresOf(const TriangleSoup& soup, const std::string& source,
                             const FindingSink& report) {
  constexpr double longest = 10;  // at an edge of about 12 degrees
  constexpr double worthAWord = 0.05;
  std::vector<Fan> fans(soup.points.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const Vec<3> area = areaOf(soup, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec<3> u = soup.corner(t, (k + 1) % 3) - soup.corner(t, k);
      const Vec<3> v = soup.corner(t, (k + 2) % 3) - soup.corner(t, k);
      fans[soup.triangles[t][k]].add(area / norm(area), std::atan2(norm(cross(u, v)), dot(u, v)));
    }
  }
  std::vector<Vec<3>> mitres;
  double worst = worthAWord;
  std::size_t worstAt = soup.points.size();
  for (std::size_t p = 0; p < soup.points.size(); ++p) {
    const Vec<3> m = fans[p].mitre();
    const double error = fans[p].error(m);
    if (!(norm(m) < longest) || error > 0.5)
      fail(fmt::format("{}: the surface is too sharp at {} for its faces to be offset together",
                       source, printed(soup.points[p])),
           "blunt the corner or edge there to 12 degrees or more, or model the wall as a closed "
           "surface",
           soup.points[p]);
    if (error > worst) {
      worst = error;
      worstAt = p;
    }
    mitres.push_back(m);
  }
  if (worstAt < mitres.size())
    report({Severity::warning,
            fmt::format("{}: faces of more than three planes meet at {}: the wall's thickness is "
                        "off by up to {:.0f} % there",
                        source, printed(soup.points[worstAt]), 100 * worst),
            "refine the mesh there if that matters", placeOf(soup.points[worstAt])});
  return mitres;
}

/// The corners moved by `way` [m]; no triangle may turn round or shrink to nothing.
std::vector<Vec<3>> shifted(const TriangleSoup& soup, const std::vector<Vec<3>>& mitres, double way,
                            const Thickening& how, const std::string& source) {
  TriangleSoup result = soup;
  for (std::size_t p = 0; p < mitres.size(); ++p) result.points[p] += way * mitres[p];
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const Vec<3> before = areaOf(soup, t);
    if (dot(areaOf(result, t), before) > 1e-6 * normSquared(before)) continue;
    fail(fmt::format("{}: a thickness of {} m is more than the surface's radius of curvature near "
                     "{}",
                     source, how.thickness, printed(soup.center(t))),
         remedyForThickness(how), soup.center(t));
  }
  return result.points;
}

}  // namespace

TriangleSoup thickened(const TriangleSoup& open, const Thickening& how, const std::string& source,
                       const FindingSink& report) {
  TriangleSoup soup = welded(open);
  if (soup.triangles.empty()) return soup;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (hasNoArea(soup, t))
      fail(fmt::format("{}: a triangle has no area, at {}", source, printed(soup.center(t))),
           "remove degenerate faces in the meshing tool and export again", soup.center(t));
  checkIsOpenSheet(soup, source);
  const double thinnest = 100 * weldingDistance(soup);
  if (how.thickness < thinnest)
    fail(fmt::format("{}: a thickness of {} m is nothing beside the part's size", source,
                     how.thickness),
         fmt::format("give {:.2g} m or more", thinnest), soup.points.front());

  const std::vector<Vec<3>> mitres = mitresOf(soup, source, report);
  const double outwards = how.side == WallSide::outer   ? how.thickness
                          : how.side == WallSide::inner ? 0
                                                        : 0.5 * how.thickness;
  TriangleSoup wall;
  wall.points = shifted(soup, mitres, outwards, how, source);
  const auto inner = shifted(soup, mitres, outwards - how.thickness, how, source);
  const std::size_t n = wall.points.size();  // from the outer corner to the inner one
  wall.points.insert(wall.points.end(), inner.begin(), inner.end());
  for (const auto& [a, b, c] : soup.triangles) {
    wall.triangles.push_back({a, b, c});
    wall.triangles.push_back({n + a, n + c, n + b});
  }
  forEachEdge(sidesOf(soup), [&](std::span<const Side> edge) {
    if (edge.size() != 1) return;
    const std::size_t from = edge[0].forward ? edge[0].low : edge[0].high;
    const std::size_t to = edge[0].forward ? edge[0].high : edge[0].low;
    wall.triangles.push_back({to, from, n + from});
    wall.triangles.push_back({to, n + from, n + to});
  });
  return wall;
}

}  // namespace plenum
