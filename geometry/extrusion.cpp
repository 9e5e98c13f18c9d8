// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/extrusion.hpp"

#include "geometry/convex_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plenum {

namespace {

Vec<2> flat(const Vec<3>& x) { return {{x[0], x[1]}}; }
Vec<3> lifted(const Vec<2>& x, double z) { return {{x[0], x[1], z}}; }

/// The points between the two ends, whatever their x and y.
struct Slab {
  double lower;  ///< [m]
  double upper;  ///< [m]

  Chord chord(const Vec<3>& x, const Vec<3>& step, double grow) const {
    return chordOfSlab(x[2], step[2], lower - grow, upper + grow);
  }
};

/// Deep inside both base and slab, or far outside of either.
class ExtrudedRows final : public RowClassifier<3> {
 public:
  ExtrudedRows(const Geometry<2>& base, const Slab& slab, const Vec<3>& step, double near)
      : base_(rowsOf(base, step, near)), slab_(slab), step_(step), near_(near) {}

  void classify(std::span<const Row<3>> rows, RowRuns& runs) const override {
    std::vector<Row<2>> below;
    for (const Row<3>& row : rows) below.push_back({flat(row.first), row.count});
    RowRuns inBase, between;
    base_->classify(below, inBase);
    classifyConvex(slab_, rows, step_, near_, between);
    runs = combined(inBase, between, [](PointPlace a, PointPlace b) { return std::min(a, b); });
  }

 private:
  /// Rows that run almost along z are points for the base: a root would be spoilt by round-off, so
  /// they are marched.
  static std::unique_ptr<const RowClassifier<2>> rowsOf(const Geometry<2>& base, const Vec<3>& step,
                                                        double near) {
    const Vec<2> below = flat(step);
    if (norm(below) > 1e-3 * norm(step)) return base.rowClassifier(below, near);
    return base.Geometry<2>::rowClassifier(below, near);
  }

  std::unique_ptr<const RowClassifier<2>> base_;
  Slab slab_;
  Vec<3> step_;
  double near_;
};

class Extrusion final : public Geometry<3> {
 public:
  using Geometry<3>::closest;

  Extrusion(GeometryPtr<2> base, double lower, double upper)
      : base_(std::move(base)), slab_{lower, upper} {}

  void closest(std::span<const Vec<3>> points, std::span<SurfacePoint<3>> result) const override {
    constexpr std::size_t chunkLength = 64;  // on the stack
    std::array<Vec<2>, chunkLength> below;
    std::array<SurfacePoint<2>, chunkLength> hits;
    for (std::size_t begin = 0; begin < points.size(); begin += chunkLength) {
      const std::size_t n = std::min(chunkLength, points.size() - begin);
      for (std::size_t k = 0; k < n; ++k) below[k] = flat(points[begin + k]);
      base_->closest(std::span(below).first(n), std::span(hits).first(n));
      for (std::size_t k = 0; k < n; ++k) result[begin + k] = onSurface(points[begin + k], hits[k]);
    }
  }

  std::unique_ptr<const RowClassifier<3>> rowClassifier(const Vec<3>& step,
                                                        double near) const override {
    return std::make_unique<const ExtrudedRows>(*base_, slab_, step, near);
  }

  Box<3> bounds() const override {
    const Box<2> box = base_->bounds();
    return {lifted(box.lower, slab_.lower), lifted(box.upper, slab_.upper), {}};
  }

  Measure volume() const override {
    const Measure area = base_->volume();
    const double height = slab_.upper - slab_.lower;
    return {height * area.value, height * area.error};
  }

  double tolerance() const override { return base_->tolerance(); }
  std::string describe() const override {
    return fmt::format("{} from z = {:.6g} to {:.6g}", base_->describe(), slab_.lower, slab_.upper);
  }

 private:
  /// The nearest point for x, with that of the base for its (x, y).
  SurfacePoint<3> onSurface(const Vec<3>& x, const SurfacePoint<2>& side) const {
    const bool upperEnd = x[2] - slab_.lower > slab_.upper - x[2];
    const double end = upperEnd ? slab_.upper : slab_.lower;
    const double pastEnd = upperEnd ? x[2] - slab_.upper : slab_.lower - x[2];
    const double pastSide = side.signedDistance;
    const Vec<3> outward{{0, 0, upperEnd ? 1. : -1.}};
    if (pastSide <= 0 && (pastEnd > 0 || pastEnd > pastSide))
      return {lifted(flat(x), end), outward, pastEnd};
    if (pastEnd <= 0) return {lifted(side.point, x[2]), lifted(side.normal, 0), pastSide};
    const double distance = std::hypot(pastSide, pastEnd);
    return {lifted(side.point, end),
            pastSide / distance * lifted(side.normal, 0) + pastEnd / distance * outward, distance};
  }

  GeometryPtr<2> base_;
  Slab slab_;
};

}  // namespace

GeometryPtr<3> extruded(GeometryPtr<2> base, double lower, double upper) {
  return std::make_shared<const Extrusion>(std::move(base), lower, upper);
}

}  // namespace plenum
