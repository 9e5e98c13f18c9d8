// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_soup.hpp"

#include "geometry/print.hpp"
#include "particles/box.hpp"
#include "particles/errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace plenum {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

Box<3> boundsOf(const TriangleSoup& soup) {
  Box<3> box = Box<3>::nothing();
  for (const Vec<3>& x : soup.points) box.extend(x);
  return box;
}

/// One side of a triangle, from the smaller to the larger corner.
struct Side {
  std::size_t low;
  std::size_t high;
  std::size_t triangle;
  bool forward;  ///< the triangle runs from low to high

  bool sameEdge(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sidesOf(const TriangleSoup& soup) {
  std::vector<Side> sides;
  sides.reserve(3 * soup.triangles.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = soup.triangles[t][k];
      const std::size_t b = soup.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  std::ranges::sort(sides, [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return sides;
}

/// Six times the volume of the tetrahedron of a triangle and `origin` [m^3].
double sixfoldVolume(const TriangleSoup& soup, std::size_t triangle, const Vec<3>& origin) {
  return dot(soup.corner(triangle, 0) - origin,
             cross(soup.corner(triangle, 1) - origin, soup.corner(triangle, 2) - origin));
}

/// A part of the surface that hangs together.
struct Shell {
  const TriangleSoup& whole;
  std::vector<std::size_t> triangles;
  Box<3> bounds = Box<3>::nothing();

  void add(std::size_t triangle) {
    triangles.push_back(triangle);
    for (std::size_t k = 0; k < 3; ++k) bounds.extend(whole.corner(triangle, k));
  }

  /// A point of it [m].
  Vec<3> somewhere() const { return whole.center(triangles.front()); }

  double signedVolume() const {
    long double sum = 0;
    for (std::size_t t : triangles) sum += sixfoldVolume(whole, t, bounds.center());
    return static_cast<double>(sum / 6);
  }

  /// By the angle under which its triangles are seen from `x`: a full sphere inside, none outside.
  /// van Oosterom & Strackee (1983), doi 10.1109/TBME.1983.325207.
  bool contains(const Vec<3>& x) const {
    if (!bounds.contains(x)) return false;
    double sum = 0;
    for (std::size_t t : triangles) {
      const Vec<3> a = whole.corner(t, 0) - x;
      const Vec<3> b = whole.corner(t, 1) - x;
      const Vec<3> c = whole.corner(t, 2) - x;
      const double la = norm(a), lb = norm(b), lc = norm(c);
      const double scale = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
      sum += 2 * std::atan2(dot(a, cross(b, c)), scale);
    }
    return std::abs(sum) > 2 * std::numbers::pi;
  }
};

void checkTriangles(const TriangleSoup& soup, const std::string& source) {
  if (soup.triangles.empty())
    throw InputError(source + ": holds no triangles; export a closed surface mesh");
  std::size_t flat = none;
  std::size_t nFlat = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const Vec<3> u = soup.corner(t, 1) - soup.corner(t, 0);
    const Vec<3> v = soup.corner(t, 2) - soup.corner(t, 0);
    const double longest = std::max({norm(u), norm(v), norm(u - v)});
    if (norm(cross(u, v)) > 1e-12 * longest * longest) continue;
    ++nFlat;
    if (flat == none) flat = t;
  }
  if (nFlat > 0)
    throw InputError(
        fmt::format("{}: {} triangle{} no area, the first at {}; remove degenerate "
                    "faces in the meshing tool and export again",
                    source, nFlat, nFlat == 1 ? " has" : "s have", printed(soup.center(flat))));
}

void checkEdges(const TriangleSoup& soup, const std::vector<Side>& sides,
                const std::string& source) {
  struct Fault {
    std::size_t n = 0;
    Vec<3> at{};
  };
  Fault open, crowded, turned;
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin;
    while (end < sides.size() && sides[end].sameEdge(sides[begin])) ++end;
    Fault* fault = end - begin == 1                                   ? &open
                   : end - begin > 2                                  ? &crowded
                   : sides[begin].forward == sides[begin + 1].forward ? &turned
                                                                      : nullptr;
    if (fault != nullptr && fault->n++ == 0)
      fault->at = 0.5 * (soup.points[sides[begin].low] + soup.points[sides[begin].high]);
    begin = end;
  }
  const auto report = [&](const Fault& fault, const char* what, const char* remedy) {
    if (fault.n > 0)
      throw InputError(fmt::format("{}: {}: {} such edge{}, the first at {}; {}", source, what,
                                   fault.n, fault.n == 1 ? "" : "s", printed(fault.at), remedy));
  };
  report(open, "the surface is not closed (edges with a triangle on one side only)",
         "close the holes in the meshing tool");
  report(crowded, "the surface is not one sheet (edges with more than two triangles)",
         "remove double or inner faces in the meshing tool");
  report(turned, "neighbouring triangles are turned against each other",
         "orient all faces coherently in the meshing tool");
}

std::vector<Shell> shellsOf(const TriangleSoup& soup, const std::vector<Side>& sides) {
  std::vector<std::size_t> parent(soup.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::size_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  for (std::size_t k = 1; k < sides.size(); ++k)
    if (sides[k].sameEdge(sides[k - 1])) {
      const std::size_t a = root(sides[k].triangle);
      const std::size_t b = root(sides[k - 1].triangle);
      parent[std::max(a, b)] = std::min(a, b);
    }
  std::vector<std::size_t> number(parent.size());
  std::vector<Shell> shells;
  for (std::size_t t = 0; t < parent.size(); ++t) {
    if (root(t) == t) {
      number[t] = shells.size();
      shells.push_back({soup, {}});
    }
    shells[number[root(t)]].add(t);
  }
  return shells;
}

/// In how many others a shell lies.
std::ptrdiff_t depthOf(const Shell& shell, const std::vector<Shell>& shells) {
  const Vec<3> point = shell.somewhere();
  return std::ranges::count_if(
      shells, [&](const Shell& other) { return &other != &shell && other.contains(point); });
}

void checkOrientation(const TriangleSoup& soup, const std::vector<Side>& sides,
                      const std::string& source) {
  const std::vector<Shell> shells = shellsOf(soup, sides);
  for (const Shell& shell : shells) {
    const Vec<3> seenAt = shell.somewhere();
    const std::ptrdiff_t depth = depthOf(shell, shells);
    const double volume = shell.signedVolume();
    if (depth % 2 == 0 && volume < 0)
      throw InputError(
          fmt::format("{}: the surface{} is inside out (its triangles run clockwise "
                      "seen from outside, volume {:.6g} m^3), seen at {}; flip its "
                      "normals in the meshing tool",
                      source, shells.size() > 1 ? " of one part" : "", volume, printed(seenAt)));
    if (depth % 2 == 1 && volume > 0)
      throw InputError(
          fmt::format("{}: a part at {} lies inside another one; flip its normals if "
                      "it is a cavity, remove it if not",
                      source, printed(seenAt)));
  }
}

}  // namespace

double signedVolume(const TriangleSoup& soup) {
  long double sum = 0;
  const Vec<3> origin = boundsOf(soup).center();  // no cancellation far from (0, 0, 0)
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) sum += sixfoldVolume(soup, t, origin);
  return static_cast<double>(sum / 6);
}

std::vector<std::size_t> mergedPoints(const std::vector<Vec<3>>& points, double near) {
  // Along a crooked direction few points coincide that are not the same.
  const Vec<3> crooked{{0.36, 0.51, 0.78}};  // shorter than 1
  std::vector<double> along;
  for (const Vec<3>& x : points) along.push_back(dot(crooked, x));
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return along[k]; });
  std::vector<std::size_t> mergedWith(points.size(), none);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t first = order[i];
    if (mergedWith[first] != none) continue;
    for (std::size_t j = i; j < order.size() && along[order[j]] - along[first] <= near; ++j)
      if (mergedWith[order[j]] == none && norm(points[order[j]] - points[first]) <= near)
        mergedWith[order[j]] = first;
  }
  return mergedWith;
}

TriangleSoup welded(const TriangleSoup& soup) {
  const std::vector<std::size_t> mergedWith =
      mergedPoints(soup.points, 1e-9 * norm(boundsOf(soup).extent()));
  TriangleSoup result;
  std::vector<std::size_t> number(soup.points.size(), none);
  for (const auto& triangle : soup.triangles) {
    std::array<std::size_t, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = mergedWith[triangle[k]];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (std::size_t& corner : corners) {
      if (number[corner] == none) {
        number[corner] = result.points.size();
        result.points.push_back(soup.points[corner]);
      }
      corner = number[corner];
    }
    result.triangles.push_back(corners);
  }
  return result;
}

TriangleSoup turnedOutwards(TriangleSoup soup) {
  // Neighbours first, shell by shell.
  std::vector<std::vector<Side>> neighbours(soup.triangles.size());
  const std::vector<Side> sides = sidesOf(soup);
  for (std::size_t k = 1; k < sides.size(); ++k)
    if (sides[k].sameEdge(sides[k - 1])) {
      const bool agree = sides[k].forward != sides[k - 1].forward;
      neighbours[sides[k].triangle].push_back({0, 0, sides[k - 1].triangle, agree});
      neighbours[sides[k - 1].triangle].push_back({0, 0, sides[k].triangle, agree});
    }
  enum State : char { unseen, kept, turned };
  std::vector<State> state(soup.triangles.size(), unseen);
  for (std::size_t first = 0; first < state.size(); ++first) {
    if (state[first] != unseen) continue;
    state[first] = kept;
    for (std::vector<std::size_t> open{first}; !open.empty();) {
      const std::size_t t = open.back();
      open.pop_back();
      for (const Side& side : neighbours[t]) {
        if (state[side.triangle] != unseen) continue;
        state[side.triangle] = side.forward == (state[t] == kept) ? kept : turned;
        open.push_back(side.triangle);
      }
    }
  }
  for (std::size_t t = 0; t < state.size(); ++t)
    if (state[t] == turned) std::swap(soup.triangles[t][1], soup.triangles[t][2]);

  TriangleSoup result{soup.points, {}};
  const std::vector<Shell> shells = shellsOf(soup, sides);
  for (const Shell& shell : shells) {
    const bool isCavity = depthOf(shell, shells) % 2 == 1;
    const bool flip = (shell.signedVolume() < 0) != isCavity;
    for (std::size_t t : shell.triangles) {
      result.triangles.push_back(soup.triangles[t]);
      if (flip) std::swap(result.triangles.back()[1], result.triangles.back()[2]);
    }
  }
  return result;
}

void checkClosedSurface(const TriangleSoup& soup, const std::string& source) {
  checkTriangles(soup, source);
  const std::vector<Side> sides = sidesOf(soup);
  checkEdges(soup, sides, source);
  checkOrientation(soup, sides, source);
}

}  // namespace plenum
