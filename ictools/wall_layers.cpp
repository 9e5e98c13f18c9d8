// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/wall_layers.hpp"

#include "ictools/layer_points.hpp"
#include "ictools/point_grid.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// Adds depth and normal to positions.
template <int Dim>
std::vector<WallPoint<Dim>> withNormals(const WallSolid<Dim>& solid,
                                        const std::vector<Vec<Dim>>& positions, double volume) {
  const auto feet = closestPoints<Dim>(*solid.geometry, positions);
  std::vector<WallPoint<Dim>> points(positions.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = {positions[k], solid.normal(feet[k]),
                 std::max(0.0, solid.depth(feet[k].signedDistance)), volume};
  return points;
}

}  // namespace

template <int Dim>
std::vector<WallPoint<Dim>> latticeLayers(const WallSolid<Dim>& solid, const Lattice<Dim>& lattice,
                                          double spacing, double thickness, const Box<Dim>& box) {
  const double roundOff = surfaceRoundOff * spacing;
  const auto positions =
      latticePoints(lattice, box, *solid.geometry, solid.band(-roundOff, thickness + roundOff));
  return withNormals(solid, positions, lattice.cellVolume());
}

template <int Dim>
std::vector<WallPoint<Dim>> conformalLayers(const WallSolid<Dim>& solid, double spacing, int layers,
                                            const Box<Dim>& box) {
  std::vector<Layer<Dim>> all;
  if constexpr (Dim == 2)
    all = traceLayers(solid, spacing, layers, box);
  else
    all = sampleLayers(solid, spacing, layers, box);
  std::size_t expected = 0;
  for (const Layer<Dim>& layer : all) expected += layer.points.size();
  PointGrid<Dim> grid(box, closestInWalls * spacing, expected);
  std::vector<WallPoint<Dim>> points;
  for (Layer<Dim>& layer : all) {
    std::erase_if(layer.points, [&](const Vec<Dim>& x) {
      if (!(grid.nearest(x) >= closestInWalls * spacing)) return true;
      grid.insert(x);
      return false;
    });
    const double share = layer.volume / static_cast<double>(layer.points.size());
    for (const WallPoint<Dim>& point : withNormals(solid, layer.points, share))
      points.push_back(point);
  }
  return points;
}

template <int Dim>
void moveToDepth(const WallSolid<Dim>& solid, double depth, double spacing,
                 std::vector<Vec<Dim>>& points) {
  constexpr int maxMoves = 6;  // one is enough unless another surface is nearer after the move
  const double near = 1e-9 * spacing;
  std::vector<double> error(points.size());
  for (int move = 0; move <= maxMoves; ++move) {
    const auto feet = closestPoints<Dim>(*solid.geometry, points);
    bool done = true;
    for (std::size_t k = 0; k < points.size(); ++k) {
      error[k] = solid.depth(feet[k].signedDistance) - depth;
      if (std::abs(error[k]) <= near || move == maxMoves) continue;
      points[k] += error[k] * solid.normal(feet[k]);
      done = false;
    }
    if (done) break;
  }
  std::size_t k = 0;
  // A mesh's own round-off may keep a good point from arriving at `near`.
  std::erase_if(points, [&](const Vec<Dim>&) { return !(std::abs(error[k++]) <= 1e-5 * spacing); });
}

template std::vector<WallPoint<1>> latticeLayers(const WallSolid<1>&, const Lattice<1>&, double,
                                                 double, const Box<1>&);
template std::vector<WallPoint<1>> conformalLayers(const WallSolid<1>&, double, int, const Box<1>&);
template void moveToDepth(const WallSolid<1>&, double, double, std::vector<Vec<1>>&);
template std::vector<WallPoint<2>> latticeLayers(const WallSolid<2>&, const Lattice<2>&, double,
                                                 double, const Box<2>&);
template std::vector<WallPoint<2>> conformalLayers(const WallSolid<2>&, double, int, const Box<2>&);
template void moveToDepth(const WallSolid<2>&, double, double, std::vector<Vec<2>>&);
template std::vector<WallPoint<3>> latticeLayers(const WallSolid<3>&, const Lattice<3>&, double,
                                                 double, const Box<3>&);
template std::vector<WallPoint<3>> conformalLayers(const WallSolid<3>&, double, int, const Box<3>&);
template void moveToDepth(const WallSolid<3>&, double, double, std::vector<Vec<3>>&);

}  // namespace plenum
