// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/rows.hpp"
#include "particles/box.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace plenum {

/// The point of a surface that is nearest to a query point. At edges and corners a surface has many
/// normals: the one given points from (or, from inside, to) the query point, so that
/// query = point + signedDistance normal holds everywhere; it is the gradient of the signed
/// distance.
template <int Dim>
struct SurfacePoint {
  Vec<Dim> point;             ///< on the surface [m]
  Vec<Dim> normal;            ///< unit normal there, out of the region
  double signedDistance = 0;  ///< of the query point [m], negative inside
};

/// An area (2-D, [m^2]) or volume (3-D, [m^3]) with a bound on its error; zero error means exact up
/// to round-off for the geometry as represented.
struct Measure {
  double value = 0;
  double error = 0;
};

/// A region of space. Queries come in batches; implementations may be called from several threads.
template <int Dim>
class Geometry {
 public:
  virtual ~Geometry() = default;

  /// result[k] = 1 if points[k] is inside, else 0. Both have the same length.
  virtual void inside(std::span<const Vec<Dim>> points, std::span<std::uint8_t> result) const;

  /// result[k] = signed distance of points[k] to the surface [m], negative inside.
  virtual void signedDistance(std::span<const Vec<Dim>> points, std::span<double> result) const;

  /// result[k] = a number of the sign of the signed distance and at most its size [m], that takes
  /// less time: exact but for set operations, of whose parts it says how near the surface of any
  /// is.
  virtual void distanceBound(std::span<const Vec<Dim>> points, std::span<double> result) const;

  /// result[k] = nearest surface point of points[k].
  virtual void closest(std::span<const Vec<Dim>> points,
                       std::span<SurfacePoint<Dim>> result) const = 0;

  /// Tells for rows of points, each `step` [m] from the one before, which points lie inside and
  /// deeper than `near` [m] > 0, which outside and further than that; the others, and any others
  /// that it cannot tell, are unknown. `near` is well above the round-off of a coordinate. The
  /// answer must not outlive the geometry. Unless overridden, rows are marched by signed distance.
  virtual std::unique_ptr<const RowClassifier<Dim>> rowClassifier(const Vec<Dim>& step,
                                                                  double near) const;

  /// A box that contains the region; infinite for a half-space and the like.
  virtual Box<Dim> bounds() const = 0;

  virtual Measure volume() const = 0;

  /// How far the represented surface may be from the intended one [m]; zero for analytic shapes.
  virtual double tolerance() const { return 0; }

  /// One line for messages: "disk of radius 0.04 at (0, 0)".
  virtual std::string describe() const = 0;

  bool isInside(const Vec<Dim>& point) const;
  double signedDistance(const Vec<Dim>& point) const;
  double distanceBound(const Vec<Dim>& point) const;
  SurfacePoint<Dim> closest(const Vec<Dim>& point) const;
};

template <int Dim>
using GeometryPtr = std::shared_ptr<const Geometry<Dim>>;

}  // namespace plenum
