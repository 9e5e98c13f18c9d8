// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_shells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>

namespace plenum {

std::vector<Side> sidesOf(const TriangleSoup& soup) {
  std::vector<Side> sides;
  sides.reserve(3 * soup.triangles.size());
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

std::vector<Hole> holesOf(const TriangleSoup& soup, const std::vector<Side>& sides) {
  constexpr std::size_t several = static_cast<std::size_t>(-1);
  std::map<std::size_t, std::size_t> next;  // against the triangle that is there
  forEachEdge(sides, [&](std::span<const Side> edge) {
    if (edge.size() != 1) return;
    const std::size_t from = edge[0].forward ? edge[0].high : edge[0].low;
    const std::size_t to = edge[0].forward ? edge[0].low : edge[0].high;
    if (!next.emplace(from, to).second) next[from] = several;
  });
  std::vector<Hole> holes;
  while (!next.empty()) {
    Hole hole;
    const std::size_t first = next.begin()->first;
    std::size_t corner = first;
    bool isClosed = false;
    for (auto step = next.find(corner); step != next.end(); step = next.find(corner)) {
      hole.corners.push_back(corner);
      corner = step->second;
      next.erase(step);
      isClosed = corner == first;
    }
    if (!isClosed || hole.corners.size() < 3) continue;
    Box<3> bounds = Box<3>::nothing();
    for (std::size_t k : hole.corners) {
      bounds.extend(soup.points[k]);
      hole.center += soup.points[k] / static_cast<double>(hole.corners.size());
    }
    hole.size = norm(bounds.extent());
    holes.push_back(std::move(hole));
  }
  return holes;
}

void Shell::add(std::size_t triangle) {
  triangles.push_back(triangle);
  for (std::size_t k = 0; k < 3; ++k) bounds.extend(whole.corner(triangle, k));
}

double Shell::signedVolume() const {
  long double sum = 0;
  for (std::size_t t : triangles) sum += sixfoldVolume(whole, t, bounds.center());
  return static_cast<double>(sum / 6);
}

bool Shell::contains(const Vec<3>& x) const {
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

std::vector<std::size_t> shellsAround(std::size_t k, const std::vector<Shell>& shells) {
  const Vec<3> point = shells[k].somewhere();
  std::vector<std::size_t> around;
  for (std::size_t other = 0; other < shells.size(); ++other)
    if (other != k && shells[other].contains(point)) around.push_back(other);
  return around;
}

}  // namespace plenum
