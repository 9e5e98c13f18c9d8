// SPDX-License-Identifier: GPL-3.0-or-later
//
// One of the sources that see CGAL.
#include "geometry/polygon.hpp"

#include "geometry/print.hpp"
#include "particles/errors.hpp"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace plenum {

namespace {

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plain = CGAL::Simple_cartesian<double>;

Exact::Point_2 exact(const Vec<2>& x) { return {x[0], x[1]}; }
Plain::Point_3 plain(const Vec<2>& x) { return {x[0], x[1], 0}; }

/// An edge of a loop, with its neighbours' far ends; the region lies on its left.
struct Edge {
  Vec<2> before;
  Vec<2> from;
  Vec<2> to;
  Vec<2> after;
  std::size_t loop = 0;

  Exact::Segment_2 segment() const { return {exact(from), exact(to)}; }
  Vec<2> outward() const {
    const Vec<2> along = to - from;
    return Vec<2>{{along[1], -along[0]}} / norm(along);
  }
};

double signedArea(const Loop& loop) {
  double sum = 0;
  const Vec<2>& origin = loop.front();  // relative to a corner: no cancellation far from (0, 0)
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec<2> a = loop[k] - origin;
    const Vec<2> b = loop[(k + 1) % loop.size()] - origin;
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * sum;
}

/// Without repeated corners, checked for size and numbers.
Loop cleaned(const Loop& loop, const std::string& source) {
  Loop result;
  for (const Vec<2>& corner : loop) {
    if (!std::isfinite(corner[0]) || !std::isfinite(corner[1]))
      throw InputError(source +
                       ": a corner of the polygon is not finite; coordinates must be numbers");
    if (result.empty() || !(result.back() == corner)) result.push_back(corner);
  }
  while (result.size() > 1 && result.back() == result.front()) result.pop_back();
  if (result.size() < 3)
    throw InputError(fmt::format(
        "{}: a loop has {} different corner{}{}; a polygon needs 3 or more", source, result.size(),
        result.size() == 1 ? "" : "s", result.empty() ? "" : " at " + printed(result.front())));
  return result;
}

std::vector<Edge> edgesOf(const std::vector<Loop>& loops) {
  std::vector<Edge> edges;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const Loop& loop = loops[l];
    const std::size_t n = loop.size();
    for (std::size_t k = 0; k < n; ++k)
      edges.push_back({loop[(k + n - 1) % n], loop[k], loop[(k + 1) % n], loop[(k + 2) % n], l});
  }
  return edges;
}

/// Two edges share more than the corner that joins them.
bool clash(const Edge& a, const Edge& b) {
  if (!CGAL::do_intersect(a.segment(), b.segment())) return false;
  const bool aThenB = a.loop == b.loop && a.to == b.from && a.after == b.to;
  const bool bThenA = a.loop == b.loop && b.to == a.from && b.after == a.to;
  if (!aThenB && !bThenA) return true;
  // Neighbours: they clash only if the second runs back along the first.
  const Edge& first = aThenB ? a : b;
  const Edge& second = aThenB ? b : a;
  return CGAL::collinear(exact(first.from), exact(first.to), exact(second.to)) &&
         dot(first.to - first.from, second.to - second.from) < 0;
}

/// Where two edges meet, good enough for a message.
Vec<2> meetingPoint(const Edge& a, const Edge& b) {
  const Vec<2> u = a.to - a.from;
  const Vec<2> v = b.to - b.from;
  const double cross = u[0] * v[1] - u[1] * v[0];
  if (std::abs(cross) < 1e-12 * norm(u) * norm(v)) return 0.25 * (a.from + a.to + b.from + b.to);
  const Vec<2> w = b.from - a.from;
  return a.from + (w[0] * v[1] - w[1] * v[0]) / cross * u;
}

/// Throws if any two edges cross or touch.
void checkCrossings(const std::vector<Edge>& edges, const std::string& source) {
  using BoxOfEdge = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Edge*>;
  std::vector<BoxOfEdge> boxes;
  for (const Edge& edge : edges) boxes.emplace_back(edge.segment().bbox(), &edge);
  std::optional<std::pair<Edge, Edge>> found;
  std::size_t nFound = 0;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                [&](const BoxOfEdge& a, const BoxOfEdge& b) {
                                  if (!clash(*a.handle(), *b.handle())) return;
                                  ++nFound;
                                  if (!found) found = {*a.handle(), *b.handle()};
                                });
  if (!found) return;
  const bool same = found->first.loop == found->second.loop;
  throw InputError(fmt::format(
      "{}: {} at {} ({} such place{}); every loop must be simple and apart from the others", source,
      same ? "a loop crosses or touches itself" : "two loops cross or touch",
      printed(meetingPoint(found->first, found->second)), nFound, nFound == 1 ? "" : "s"));
}

bool contains(const Loop& loop, const Vec<2>& x) {
  std::vector<Exact::Point_2> corners;
  for (const Vec<2>& corner : loop) corners.push_back(exact(corner));
  return CGAL::bounded_side_2(corners.begin(), corners.end(), exact(x), Exact()) ==
         CGAL::ON_BOUNDED_SIDE;
}

void orient(Loop& loop, bool counterClockwise) {
  if ((signedArea(loop) > 0) != counterClockwise) std::reverse(loop.begin() + 1, loop.end());
}

/// Holes lie in their outer line and not in each other; polygons are apart. Nothing crosses.
void checkNesting(const std::vector<PolygonLoops>& polygons, const std::string& source) {
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    for (std::size_t q = 0; q < polygons.size(); ++q) {
      const auto isHole = [&](const Loop& hole) {
        return contains(hole, polygons[p].outer.front());
      };
      if (p != q && contains(polygons[q].outer, polygons[p].outer.front()) &&
          std::ranges::none_of(polygons[q].holes, isHole))
        throw InputError(source + ": two polygons overlap near " +
                         printed(polygons[p].outer.front()) + "; keep one of them");
    }
    for (const Loop& hole : polygons[p].holes) {
      if (!contains(polygons[p].outer, hole.front()))
        throw InputError(source + ": a hole lies outside of its polygon at " +
                         printed(hole.front()) + "; move it inside or remove it");
      for (const Loop& other : polygons[p].holes)
        if (&other != &hole && contains(other, hole.front()))
          throw InputError(source + ": a hole lies inside another one at " + printed(hole.front()) +
                           "; remove the inner one");
    }
  }
}

class Polygon final : public Geometry<2> {
 public:
  using Geometry<2>::closest;

  Polygon(const std::vector<Loop>& loops, std::string description, double tolerance)
      : edges_(edgesOf(loops)), description_(std::move(description)), tolerance_(tolerance) {
    segments_.reserve(edges_.size());
    for (const Edge& edge : edges_) {
      segments_.emplace_back(plain(edge.from), plain(edge.to));
      bounds_.extend(edge.from);
    }
    for (const Loop& loop : loops) area_ += signedArea(loop);
    tree_.insert(segments_.begin(), segments_.end());
    tree_.build();
    tree_.accelerate_distance_queries();  // now, so that queries only read
  }

  void closest(std::span<const Vec<2>> points, std::span<SurfacePoint<2>> result) const override {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto hit = tree_.closest_point_and_primitive(plain(points[k]));
      result[k] =
          onEdge(edges_[static_cast<std::size_t>(hit.second - segments_.begin())], points[k]);
    }
  }

  Box<2> bounds() const override { return bounds_; }
  Measure volume() const override { return {area_, 0}; }
  double tolerance() const override { return tolerance_; }
  std::string describe() const override {
    return fmt::format("polygon of {} edges ({})", edges_.size(), description_);
  }

 private:
  using Segments = std::vector<Plain::Segment_3>;
  using Tree = CGAL::AABB_tree<
      CGAL::AABB_traits<Plain, CGAL::AABB_segment_primitive<Plain, Segments::const_iterator>>>;

  static SurfacePoint<2> onEdge(const Edge& edge, const Vec<2>& x) {
    const Vec<2> along = edge.to - edge.from;
    const double share = dot(x - edge.from, along) / normSquared(along);
    if (share <= 0) return onCorner(edge.before, edge.from, edge.to, x);
    if (share >= 1) return onCorner(edge.from, edge.to, edge.after, x);
    const Vec<2> outward = edge.outward();
    const double distance = std::abs(dot(outward, x - edge.from));
    const auto side = CGAL::orientation(exact(edge.from), exact(edge.to), exact(x));
    const double sign = side == CGAL::LEFT_TURN ? -1 : side == CGAL::RIGHT_TURN ? 1 : 0;
    return {x - sign * distance * outward, outward, sign * distance};
  }

  /// Where a corner is nearest: the outer side sees convex corners, the inner side reflex ones, and
  /// either side those in the middle of a straight line.
  static SurfacePoint<2> onCorner(const Vec<2>& before, const Vec<2>& corner, const Vec<2>& after,
                                  const Vec<2>& x) {
    auto turn = CGAL::orientation(exact(before), exact(corner), exact(after));
    if (turn == CGAL::COLLINEAR) turn = -CGAL::orientation(exact(before), exact(corner), exact(x));
    const double sign = turn == CGAL::LEFT_TURN ? 1 : -1;
    const double distance = norm(x - corner);
    if (distance > 1e-14 * (norm(x) + norm(corner)))
      return {corner, sign / distance * (x - corner), sign * distance};
    const Vec<2> both =
        Edge{{}, before, corner, {}}.outward() + Edge{{}, corner, after, {}}.outward();
    const double length = norm(both);
    return {corner, length > 0 ? both / length : Edge{{}, corner, after, {}}.outward(), 0};
  }

  std::vector<Edge> edges_;
  Segments segments_;
  Tree tree_;
  Box<2> bounds_ = Box<2>::nothing();
  double area_ = 0;
  std::string description_;
  double tolerance_;
};

}  // namespace

std::vector<PolygonLoops> nestedLoops(const std::vector<Loop>& loops, const std::string& source) {
  if (loops.empty()) throw InputError(source + ": holds no polygon; give three corners or more");
  std::vector<Loop> clean;
  for (const Loop& loop : loops) clean.push_back(cleaned(loop, source));
  checkCrossings(edgesOf(clean), source);
  std::vector<std::vector<std::size_t>> around(clean.size());  // loops that contain each loop
  for (std::size_t k = 0; k < clean.size(); ++k)
    for (std::size_t j = 0; j < clean.size(); ++j)
      if (j != k && contains(clean[j], clean[k].front())) around[k].push_back(j);

  std::vector<PolygonLoops> polygons;
  std::vector<std::size_t> polygonOf(clean.size());
  for (std::size_t k = 0; k < clean.size(); ++k) {
    if (around[k].size() % 2 != 0) continue;
    polygonOf[k] = polygons.size();
    polygons.push_back({clean[k], {}});
  }
  for (std::size_t k = 0; k < clean.size(); ++k) {
    if (around[k].size() % 2 == 0) continue;
    const std::size_t parent =
        *std::ranges::max_element(around[k], {}, [&](std::size_t j) { return around[j].size(); });
    polygons[polygonOf[parent]].holes.push_back(clean[k]);
  }
  return polygons;
}

GeometryPtr<2> makePolygon(std::vector<PolygonLoops> polygons, const std::string& source,
                           double tolerance) {
  if (polygons.empty()) throw InputError(source + ": holds no polygon; give three corners or more");
  std::vector<Loop> loops;
  for (PolygonLoops& polygon : polygons) {
    polygon.outer = cleaned(polygon.outer, source);
    orient(polygon.outer, true);
    loops.push_back(polygon.outer);
    for (Loop& hole : polygon.holes) {
      hole = cleaned(hole, source);
      orient(hole, false);
      loops.push_back(hole);
    }
  }
  checkCrossings(edgesOf(loops), source);
  checkNesting(polygons, source);
  return std::make_shared<const Polygon>(loops, source, tolerance);
}

}  // namespace plenum
