// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conformal layers in two dimensions: curves of constant depth from marching squares on a grid,
// brought onto the depth exactly, cut at corners, and points put evenly along each piece.
#include "ictools/layer_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace plenum {

namespace {

/// Grid cells a spacing: the tightest curve, the first layer around a sharp corner, has radius 1/2
/// spacing and turns by at most 32 degrees from one grid cell to the next.
constexpr int cellsPerSpacing = 5;

/// A curve that turns more than this between two vertices has a corner there.
const double cornerCosine = std::cos(40 * 3.14159265358979 / 180);

struct Curve {
  std::vector<Vec<2>> points;
  bool isClosed = false;
};

/// Depths at the nodes of a grid over a box; nodes away from the layers hold NaN.
class DepthGrid {
 public:
  DepthGrid(const WallSolid<2>& solid, double spacing, int layers, const Box<2>& box) {
    Box<2> open{box.lower, box.upper, {}};
    Lattice<2> lattice("square", spacing / cellsPerSpacing);
    lattice.fitTo(box);
    lattice.placeAt(box.lower);
    lower_ = box.lower;
    edge_ = lattice.edges();
    for (int a = 0; a < 2; ++a)
      n_[a] = std::llround(std::floor((box.upper[a] - box.lower[a]) / edge_[a] + 1e-6)) + 1;
    depths_.assign(static_cast<std::size_t>(n_[0] * n_[1]),
                   std::numeric_limits<double>::quiet_NaN());
    const double margin = 3 * norm(edge_);
    const auto nodes = latticePoints(lattice, open, *solid.geometry,
                                     solid.band(-margin, layers * spacing + margin));
    const auto distances = signedDistances<2>(*solid.geometry, nodes);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const auto i = std::llround((nodes[k][0] - lower_[0]) / edge_[0]);
      const auto j = std::llround((nodes[k][1] - lower_[1]) / edge_[1]);
      if (i < n_[0] && j < n_[1]) depths_[index(i, j)] = solid.depth(distances[k]);
    }
  }

  /// Curves of constant depth; those that leave the box are open.
  std::vector<Curve> curves(double depth) const;

 private:
  using Index = std::int64_t;
  struct Links {
    Index edges[2] = {-1, -1};  // the neighbours of a crossed grid edge along the curve
    bool used = false;
    void add(Index edge) { edges[edges[0] < 0 ? 0 : 1] = edge; }
  };
  using Crossings = std::unordered_map<Index, Links>;

  std::size_t index(Index i, Index j) const { return static_cast<std::size_t>(j * n_[0] + i); }

  /// Number of the grid edge that leaves node (i, j) along an axis.
  Index edge(Index i, Index j, int axis) const { return 2 * (j * n_[0] + i) + axis; }
  void link(Index i, Index j, double depth, Crossings& crossings, std::vector<Index>& order) const;
  Vec<2> crossing(Index edge, double depth) const;

  Vec<2> lower_;
  Vec<2> edge_;
  Index n_[2];
  std::vector<double> depths_;
};

/// Joins the edges of cell (i, j) that the curve crosses.
void DepthGrid::link(Index i, Index j, double depth, Crossings& crossings,
                     std::vector<Index>& order) const {
  const double corner[] = {depths_[index(i, j)], depths_[index(i + 1, j)],
                           depths_[index(i + 1, j + 1)], depths_[index(i, j + 1)]};
  const Index side[] = {edge(i, j, 0), edge(i + 1, j, 1), edge(i, j + 1, 0), edge(i, j, 1)};
  Index crossed[4];
  int nCrossed = 0;
  for (int s = 0; s < 4; ++s) {
    if (std::isnan(corner[s])) return;
    if ((corner[s] >= depth) != (corner[(s + 1) % 4] >= depth)) crossed[nCrossed++] = side[s];
  }
  const auto join = [&](Index a, Index b) {
    for (Index e : {a, b})
      if (crossings.find(e) == crossings.end()) order.push_back(e);
    crossings[a].add(b);
    crossings[b].add(a);
  };
  if (nCrossed == 2) return join(crossed[0], crossed[1]);
  if (nCrossed != 4) return;
  // A saddle: the mean decides which corners belong together.
  const bool centerIsDeep = std::accumulate(corner, corner + 4, 0.0) / 4 >= depth;
  const int first = centerIsDeep == (corner[0] >= depth) ? 0 : 3;
  join(crossed[first], crossed[(first + 1) % 4]);
  join(crossed[(first + 2) % 4], crossed[(first + 3) % 4]);
}

Vec<2> DepthGrid::crossing(Index edge, double depth) const {
  const int axis = static_cast<int>(edge % 2);
  const Index i = edge / 2 % n_[0];
  const Index j = edge / 2 / n_[0];
  const double a = depths_[index(i, j)];
  const double b = axis == 0 ? depths_[index(i + 1, j)] : depths_[index(i, j + 1)];
  Vec<2> x{{lower_[0] + static_cast<double>(i) * edge_[0],
            lower_[1] + static_cast<double>(j) * edge_[1]}};
  x[axis] += (depth - a) / (b - a) * edge_[axis];
  return x;
}

std::vector<Curve> DepthGrid::curves(double depth) const {
  Crossings crossings;
  std::vector<Index> order;  // of first sight, so that the result does not depend on the hash
  for (Index j = 0; j + 1 < n_[1]; ++j)
    for (Index i = 0; i + 1 < n_[0]; ++i) link(i, j, depth, crossings, order);
  std::vector<Curve> result;
  const auto follow = [&](Index start) {
    Curve curve;
    Index at = start;
    while (true) {
      Links& links = crossings[at];
      links.used = true;
      curve.points.push_back(crossing(at, depth));
      const auto isFree = [&](Index e) { return e >= 0 && !crossings[e].used; };
      if (isFree(links.edges[0]))
        at = links.edges[0];
      else if (isFree(links.edges[1]))
        at = links.edges[1];
      else
        break;
    }
    const Links& last = crossings[at];
    curve.isClosed = curve.points.size() > 2 && (last.edges[0] == start || last.edges[1] == start);
    result.push_back(std::move(curve));
  };
  for (const bool wantsEnds : {true, false})  // open curves must be entered at an end
    for (Index e : order)
      if (!crossings[e].used && (!wantsEnds || crossings[e].edges[1] < 0)) follow(e);
  return result;
}

/// A piece of a curve between corners.
struct Piece {
  std::vector<Vec<2>> points;
  bool startsAtCorner = false;
  bool endsAtCorner = false;
  bool isLoop = false;

  double length() const {
    double sum = 0;
    for (std::size_t k = 1; k < points.size(); ++k) sum += norm(points[k] - points[k - 1]);
    return sum;
  }
};

/// Where the straight continuations of two neighbouring vertices meet, if they are a corner.
bool cornerBetween(const Vec<2>& a, const Vec<2>& normalA, const Vec<2>& b, const Vec<2>& normalB,
                   Vec<2>& corner) {
  if (dot(normalA, normalB) > cornerCosine) return false;
  const double determinant = normalA[0] * normalB[1] - normalA[1] * normalB[0];
  if (std::abs(determinant) < 1e-3) return false;
  const double p = dot(normalA, a), q = dot(normalB, b);
  corner = Vec<2>{{p * normalB[1] - q * normalA[1], q * normalA[0] - p * normalB[0]}} / determinant;
  return norm(corner - a) < 4 * norm(b - a) && norm(corner - b) < 4 * norm(b - a);
}

/// Cuts a curve at its corners.
std::vector<Piece> cut(const WallSolid<2>& solid, const Curve& curve) {
  const auto feet = closestPoints<2>(*solid.geometry, curve.points);
  std::vector<Piece> pieces(1);
  const std::size_t n = curve.points.size();
  for (std::size_t k = 0; k < n; ++k) {
    pieces.back().points.push_back(curve.points[k]);
    if (k + 1 == n && !curve.isClosed) break;
    const std::size_t next = (k + 1) % n;
    Vec<2> corner;
    if (!cornerBetween(curve.points[k], feet[k].normal, curve.points[next], feet[next].normal,
                       corner))
      continue;
    pieces.back().points.push_back(corner);
    pieces.back().endsAtCorner = true;
    pieces.push_back({{corner}, true, false, false});
  }
  if (!curve.isClosed) return pieces;
  Piece& last = pieces.back();
  const std::vector<Vec<2>>& head = pieces.front().points;
  if (pieces.size() == 1) {
    last.points.push_back(head.front());
    last.isLoop = true;
    return pieces;
  }
  last.points.insert(last.points.end(), head.begin(), head.end());
  last.endsAtCorner = true;
  pieces.erase(pieces.begin());
  return pieces;
}

/// Points evenly along a piece. A corner gets one (the piece that starts there puts it); an end
/// that leaves the box stays half an interval away from it, so that periodic images continue the
/// row.
void spread(const Piece& piece, double spacing, std::vector<Vec<2>>& result) {
  const double length = piece.length();
  // In intervals: from the start to the first point, and from the last point to the end.
  const double lead = piece.startsAtCorner || piece.isLoop ? 0 : 0.5;
  const double trail = piece.endsAtCorner || piece.isLoop ? 1 : 0.5;
  const auto count =
      static_cast<int>(std::max(1.0, std::round(length / spacing + 1 - lead - trail)));
  const double step = length / (lead + count - 1 + trail);
  std::size_t k = 1;
  double passed = 0;
  for (int i = 0; i < count; ++i) {
    const double wanted = (lead + i) * step;
    while (k + 1 < piece.points.size() &&
           passed + norm(piece.points[k] - piece.points[k - 1]) < wanted) {
      passed += norm(piece.points[k] - piece.points[k - 1]);
      ++k;
    }
    const Vec<2> along = piece.points[k] - piece.points[k - 1];
    const double segment = norm(along);
    const double t = segment > 0 ? std::clamp((wanted - passed) / segment, 0.0, 1.0) : 0;
    result.push_back(piece.points[k - 1] + t * along);
  }
}

}  // namespace

double bytesOfTracing(double spacing, double area) {
  const double edge = spacing / cellsPerSpacing;
  return sizeof(double) * area / (edge * edge);
}

std::vector<Layer<2>> traceLayers(const WallSolid<2>& solid, double spacing, int layers,
                                  const Box<2>& box) {
  const DepthGrid grid(solid, spacing, layers, box);
  std::vector<Layer<2>> result;
  for (int k = 0; k < layers; ++k) {
    Layer<2> layer;
    for (Curve& curve : grid.curves(layerDepth(k, spacing))) {
      moveToDepth(solid, layerDepth(k, spacing), spacing, curve.points);
      if (curve.points.empty()) continue;
      if (curve.points.size() == 1) {
        layer.points.push_back(curve.points.front());
        continue;
      }
      for (const Piece& piece : cut(solid, curve)) {
        layer.volume += piece.length() * spacing;
        spread(piece, spacing, layer.points);
      }
    }
    moveToDepth(solid, layerDepth(k, spacing), spacing, layer.points);
    result.push_back(std::move(layer));
  }
  return result;
}

}  // namespace plenum
