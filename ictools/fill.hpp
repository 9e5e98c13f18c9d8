// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lattice points that lie inside a geometry, or in a layer along its surface.
//
// Points on the surface. A point nearer to the surface than `surfaceRoundOff` d_ref counts as lying
// on it. Such a point belongs to the wall behind that surface, never to the fluid in front of it;
// without a wall nobody stands there.
#pragma once

#include "geometry/geometry.hpp"
#include "ictools/lattice.hpp"

#include <limits>
#include <span>
#include <vector>

namespace plenum {

/// In d_ref; far above the round-off of a signed distance, far below anything that matters.
inline constexpr double surfaceRoundOff = 1e-6;

/// A range of signed distances [m], ends included.
struct DistanceBand {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// All points of `lattice` in `box`, row by row.
template <int Dim>
std::vector<Vec<Dim>> latticePoints(const Lattice<Dim>& lattice, const Box<Dim>& box);

/// Points of `lattice` in `box` whose signed distance to `geometry` lies in `band`, row by row; the
/// same for any number of threads. For what lies inside (`band.lower` infinite, `band.upper` about
/// zero) or on the surface (both about zero) the geometry tells whole runs of a row at once
/// (Geometry::rowClassifier), and only points at the surface are asked for their distance. In other
/// bands rows are marched: a point whose distance is well inside (or outside) the band decides for
/// its neighbours too, so the number of queries grows with the surface and not with the volume.
template <int Dim>
std::vector<Vec<Dim>> latticePoints(const Lattice<Dim>& lattice, const Box<Dim>& box,
                                    const Geometry<Dim>& geometry, DistanceBand band);

/// Which points surely lie inside of `geometry`, and which outside, by more than `near` [m]; from
/// all threads. Points that follow each other `edge` [m] apart along x, as lattice points do, are
/// asked for as one row.
template <int Dim>
std::vector<PointPlace> placesOf(const Geometry<Dim>& geometry, std::span<const Vec<Dim>> points,
                                 double edge, double near);

/// Signed distances [m] of all points, from all threads.
template <int Dim>
std::vector<double> signedDistances(const Geometry<Dim>& geometry,
                                    std::span<const Vec<Dim>> points);

/// Nearest surface points of all points, from all threads.
template <int Dim>
std::vector<SurfacePoint<Dim>> closestPoints(const Geometry<Dim>& geometry,
                                             std::span<const Vec<Dim>> points);

}  // namespace plenum
