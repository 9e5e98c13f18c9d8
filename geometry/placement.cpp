// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/placement.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace plenum {

namespace {

/// Asks about rows in the frame of the shape.
template <int Dim>
class PlacedRows final : public RowClassifier<Dim> {
 public:
  PlacedRows(std::unique_ptr<const RowClassifier<Dim>> own, const Placement<Dim>& placement)
      : own_(std::move(own)), placement_(placement) {}

  void classify(std::span<const Row<Dim>> rows, RowRuns& runs) const override {
    std::vector<Row<Dim>> moved(rows.begin(), rows.end());
    for (Row<Dim>& row : moved) row.first = placement_.invert(row.first);
    own_->classify(moved, runs);
  }

 private:
  std::unique_ptr<const RowClassifier<Dim>> own_;
  Placement<Dim> placement_;
};

template <int Dim>
class PlacedGeometry final : public Geometry<Dim> {
 public:
  using Geometry<Dim>::closest;
  using Geometry<Dim>::distanceBound;

  PlacedGeometry(GeometryPtr<Dim> shape, const Placement<Dim>& placement)
      : shape_(std::move(shape)), placement_(placement) {}

  void closest(std::span<const Vec<Dim>> points,
               std::span<SurfacePoint<Dim>> result) const override {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const SurfacePoint<Dim> hit = shape_->closest(placement_.invert(points[k]));
      result[k] = {placement_.apply(hit.point), placement_.turned(hit.normal),
                   placement_.scale * hit.signedDistance};
    }
  }

  void distanceBound(std::span<const Vec<Dim>> points, std::span<double> result) const override {
    for (std::size_t k = 0; k < points.size(); ++k)
      result[k] = placement_.scale * shape_->distanceBound(placement_.invert(points[k]));
  }

  std::unique_ptr<const RowClassifier<Dim>> rowClassifier(const Vec<Dim>& step,
                                                          double near) const override {
    const double scale = placement_.scale;
    return std::make_unique<const PlacedRows<Dim>>(
        shape_->rowClassifier(placement_.turnedBack(step) / scale, near / scale), placement_);
  }

  /// Of the turned corners of the shape's own box: it contains the region but may be loose.
  Box<Dim> bounds() const override {
    const Box<Dim> own = shape_->bounds();
    Box<Dim> box = Box<Dim>::nothing();
    if (!own.isFinite()) {
      box.upper = Vec<Dim>::filled(std::numeric_limits<double>::infinity());
      box.lower = -box.upper;
      return box;
    }
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      Vec<Dim> x;
      for (int a = 0; a < Dim; ++a) x[a] = (corner >> a) & 1 ? own.upper[a] : own.lower[a];
      box.extend(placement_.apply(x));
    }
    return box;
  }

  Measure volume() const override {
    const Measure own = shape_->volume();
    const double factor = std::pow(placement_.scale, Dim);
    return {factor * own.value, factor * own.error};
  }

  double tolerance() const override { return placement_.scale * shape_->tolerance(); }
  std::string describe() const override { return shape_->describe() + ", moved"; }

 private:
  GeometryPtr<Dim> shape_;
  Placement<Dim> placement_;
};

}  // namespace

template <int Dim>
void Placement<Dim>::rotate(double angle, const std::array<double, 3>& axis) {
  const double radians = angle * std::numbers::pi / 180;
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  if constexpr (Dim == 2) {
    rotation = {Vec<2>{{c, -s}}, Vec<2>{{s, c}}};
  } else if constexpr (Dim == 3) {  // Rodrigues' formula
    const auto [x, y, z] = axis;
    const double length = std::hypot(x, y, z);
    const Vec<3> u = Vec<3>{{x, y, z}} / length;
    const double k = 1 - c;
    rotation = {
        Vec<3>{{c + k * u[0] * u[0], k * u[0] * u[1] - s * u[2], k * u[0] * u[2] + s * u[1]}},
        Vec<3>{{k * u[1] * u[0] + s * u[2], c + k * u[1] * u[1], k * u[1] * u[2] - s * u[0]}},
        Vec<3>{{k * u[2] * u[0] - s * u[1], k * u[2] * u[1] + s * u[0], c + k * u[2] * u[2]}}};
  }
}

template <int Dim>
GeometryPtr<Dim> placed(GeometryPtr<Dim> shape, const Placement<Dim>& placement) {
  if (placement.isIdentity()) return shape;
  return std::make_shared<const PlacedGeometry<Dim>>(std::move(shape), placement);
}

template struct Placement<1>;
template struct Placement<2>;
template struct Placement<3>;
template GeometryPtr<1> placed<1>(GeometryPtr<1>, const Placement<1>&);
template GeometryPtr<2> placed<2>(GeometryPtr<2>, const Placement<2>&);
template GeometryPtr<3> placed<3>(GeometryPtr<3>, const Placement<3>&);

}  // namespace plenum
