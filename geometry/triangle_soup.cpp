// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_soup.hpp"

#include <algorithm>
#include <numeric>

namespace plenum {

namespace {
constexpr std::size_t none = static_cast<std::size_t>(-1);
}

Box<3> boundsOf(const TriangleSoup& soup) {
  Box<3> box = Box<3>::nothing();
  for (const Vec<3>& x : soup.points) box.extend(x);
  return box;
}

bool hasNoArea(const TriangleSoup& soup, std::size_t triangle) {
  const Vec<3> u = soup.corner(triangle, 1) - soup.corner(triangle, 0);
  const Vec<3> v = soup.corner(triangle, 2) - soup.corner(triangle, 0);
  const double longest = std::max({norm(u), norm(v), norm(u - v)});
  return !(norm(cross(u, v)) > 1e-12 * longest * longest);
}

double sixfoldVolume(const TriangleSoup& soup, std::size_t triangle, const Vec<3>& origin) {
  return dot(soup.corner(triangle, 0) - origin,
             cross(soup.corner(triangle, 1) - origin, soup.corner(triangle, 2) - origin));
}

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

double weldingDistance(const TriangleSoup& soup) { return 1e-9 * norm(boundsOf(soup).extent()); }

TriangleSoup welded(const TriangleSoup& soup) {
  const std::vector<std::size_t> mergedWith = mergedPoints(soup.points, weldingDistance(soup));
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

}  // namespace plenum
