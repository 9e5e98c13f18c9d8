// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two ways to spread points over the surfaces of constant depth behind a wall.
#pragma once

#include "ictools/wall_layers.hpp"

#include <vector>

namespace plenum {

/// Points of one conformal layer.
template <int Dim>
struct Layer {
  std::vector<Vec<Dim>> points;
  double volume = 0;  ///< of the layer, one spacing thick [m^d]
};

/// Depth [m] of layer k = 0, 1, ...
inline double layerDepth(int k, double spacing) { return (k + 0.5) * spacing; }

/// Moves each point along the normal to `depth` [m]; points that do not arrive (they would have to
/// cross the middle between two surfaces) are removed.
template <int Dim>
void moveToDepth(const WallSolid<Dim>& solid, double depth, double spacing,
                 std::vector<Vec<Dim>>& points);

/// Curves of constant depth by marching squares, points evenly along them.
std::vector<Layer<2>> traceLayers(const WallSolid<2>& solid, double spacing, int layers,
                                  const Box<2>& box);

/// Bytes of the grid that curves are found on in a box of this area [m^2].
double bytesOfTracing(double spacing, double area);

/// A fine lattice projected onto the layers, thinned and relaxed.
template <int Dim>
std::vector<Layer<Dim>> sampleLayers(const WallSolid<Dim>& solid, double spacing, int layers,
                                     const Box<Dim>& box);

}  // namespace plenum
