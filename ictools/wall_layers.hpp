// SPDX-License-Identifier: GPL-3.0-or-later
//
// Particles behind one surface: the lattice continued, or conformal layers.
#pragma once

#include "geometry/geometry.hpp"
#include "ictools/fill.hpp"

#include <vector>

namespace plenum {

/// The solid behind a wall: a region, or everything outside of one.
template <int Dim>
struct WallSolid {
  GeometryPtr<Dim> geometry;
  bool isOutside = false;

  /// Depth behind the surface of a point with this signed distance to `geometry` [m].
  double depth(double signedDistance) const { return isOutside ? signedDistance : -signedDistance; }

  /// Unit normal into the fluid; depth falls along it.
  Vec<Dim> normal(const SurfacePoint<Dim>& foot) const {
    return isOutside ? -foot.normal : foot.normal;
  }

  /// Signed distances of all depths from `shallow` to `deep` [m].
  DistanceBand band(double shallow, double deep) const {
    return isOutside ? DistanceBand{shallow, deep} : DistanceBand{-deep, -shallow};
  }
};

template <int Dim>
struct WallPoint {
  Vec<Dim> position;  ///< [m]
  Vec<Dim> normal;    ///< of the nearest surface, into the fluid
  double depth = 0;   ///< behind the surface [m]
  double volume = 0;  ///< that it stands for [m^d]
};

/// Lattice points in `box` from the surface (included) to `thickness` [m] behind it; each stands
/// for one cell.
template <int Dim>
std::vector<WallPoint<Dim>> latticeLayers(const WallSolid<Dim>& solid, const Lattice<Dim>& lattice,
                                          double spacing, double thickness, const Box<Dim>& box);

/// Layers at depths (k - 1/2) `spacing`, k = 1 ... `layers`, in `box`.
///
/// 2-D: each layer is traced as a curve; points stand evenly along it, about `spacing` apart, one
/// at each inward corner. 3-D: a fine lattice is projected onto each layer, thinned and relaxed
/// along it. Where layers of opposite surfaces meet, points nearer than 0.6 `spacing` to one of a
/// shallower layer are left out. All points of a layer stand for the same volume: the layer's (2-D:
/// length times spacing, which is exact for the band between (k - 1) and k spacings) over their
/// number.
template <int Dim>
std::vector<WallPoint<Dim>> conformalLayers(const WallSolid<Dim>& solid, double spacing, int layers,
                                            const Box<Dim>& box);

/// Smallest distance of two wall particles that were not made by the same lattice, in d_ref.
inline constexpr double closestInWalls = 0.6;

}  // namespace plenum
