// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layers from a fine lattice: every fine point is projected onto the layer it lies in; a greedy
// pass keeps points some spacing apart; Lloyd's iteration (each point moves to the mean of the fine
// points nearest to it, then back onto the layer) evens them out.
#include "ictools/layer_points.hpp"
#include "ictools/point_grid.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace plenum {

namespace {

constexpr int finePerSpacing = 3;
constexpr int relaxations = 12;
/// Of the greedy pass; gives about one point a spacing squared (tests/unit/ictools/walls_test.cpp).
constexpr double greedyDistance = 0.84;

constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

template <int Dim>
std::vector<Vec<Dim>> thinned(const std::vector<Vec<Dim>>& fine, double distance,
                              const Box<Dim>& box) {
  PointGrid<Dim> grid(box, distance, fine.size());
  std::vector<Vec<Dim>> kept;
  for (const Vec<Dim>& x : fine) {
    if (grid.nearest(x) < distance) continue;
    grid.insert(x);
    kept.push_back(x);
  }
  return kept;
}

/// Moves every point to the mean of the fine points that are nearest to it.
template <int Dim>
void moveToMeans(const std::vector<Vec<Dim>>& fine, double spacing, const Box<Dim>& box,
                 std::vector<Vec<Dim>>& points) {
  const PointGrid<Dim> grid(box, 2 * spacing, points);
  std::vector<std::size_t> owner(fine.size(), nobody);
  constexpr std::size_t batch = 1024;
  parallelFor((fine.size() + batch - 1) / batch, [&](std::size_t b) {
    for (std::size_t k = b * batch; k < std::min(fine.size(), (b + 1) * batch); ++k) {
      double best = std::numeric_limits<double>::infinity();
      grid.forEachNear(fine[k], [&](std::size_t p, double squared) {
        if (squared > best || (squared == best && p > owner[k])) return;
        best = squared;
        owner[k] = p;
      });
    }
  });
  std::vector<Vec<Dim>> offset(points.size());
  std::vector<double> count(points.size(), 0);
  for (std::size_t k = 0; k < fine.size(); ++k) {
    if (owner[k] == nobody) continue;
    offset[owner[k]] += box.nearestImage(fine[k] - points[owner[k]]);
    count[owner[k]] += 1;
  }
  for (std::size_t p = 0; p < points.size(); ++p)
    if (count[p] > 0) points[p] = box.wrap(points[p] + offset[p] / count[p]);
}

}  // namespace

template <int Dim>
std::vector<Layer<Dim>> sampleLayers(const WallSolid<Dim>& solid, double spacing, int layers,
                                     const Box<Dim>& box) {
  Lattice<Dim> lattice(Dim == 1   ? "uniform"
                       : Dim == 2 ? "square"
                                  : "cubic",
                       spacing / finePerSpacing);
  lattice.fitTo(box);
  // Off the half-spacing positions, so that no row of fine points lies between two layers.
  lattice.startAt(box.lower + Vec<Dim>::filled(0.1234 * spacing));
  const auto candidates =
      latticePoints(lattice, box, *solid.geometry, solid.band(0, layers * spacing));
  // Found and moved with one question to the geometry, which is what the time goes into.
  std::vector<std::vector<Vec<Dim>>> fine(static_cast<std::size_t>(layers));
  constexpr std::size_t batch = 65536;  // of 27 and more for each particle: feet of all are many
  for (std::size_t first = 0; first < candidates.size(); first += batch) {
    const auto part =
        std::span(candidates).subspan(first, std::min(batch, candidates.size() - first));
    const auto feet = closestPoints<Dim>(*solid.geometry, part);
    for (std::size_t k = 0; k < part.size(); ++k) {
      const double depth = solid.depth(feet[k].signedDistance);
      const int layer = std::clamp(static_cast<int>(depth / spacing), 0, layers - 1);
      fine[static_cast<std::size_t>(layer)].push_back(
          part[k] + (depth - layerDepth(layer, spacing)) * solid.normal(feet[k]));
    }
  }
  std::vector<Layer<Dim>> result;
  for (int k = 0; k < layers; ++k) {
    std::vector<Vec<Dim>>& points = fine[static_cast<std::size_t>(k)];
    Layer<Dim> layer;
    layer.volume = static_cast<double>(points.size()) * lattice.cellVolume();
    moveToDepth(solid, layerDepth(k, spacing), spacing, points);
    for (Vec<Dim>& x : points) x = box.wrap(x);
    layer.points = thinned(points, greedyDistance * spacing, box);
    for (int pass = 0; pass < relaxations && Dim > 1; ++pass) {
      moveToMeans(points, spacing, box, layer.points);
      moveToDepth(solid, layerDepth(k, spacing), spacing, layer.points);
    }
    for (Vec<Dim>& x : layer.points) x = box.wrap(x);
    if constexpr (Dim == 1) layer.volume = spacing * static_cast<double>(layer.points.size());
    result.push_back(std::move(layer));
  }
  return result;
}

template std::vector<Layer<1>> sampleLayers(const WallSolid<1>&, double, int, const Box<1>&);
template std::vector<Layer<2>> sampleLayers(const WallSolid<2>&, double, int, const Box<2>&);
template std::vector<Layer<3>> sampleLayers(const WallSolid<3>&, double, int, const Box<3>&);

}  // namespace plenum
