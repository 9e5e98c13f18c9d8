// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a Geometry of a shape that has formulas. A shape is a plain struct with
//   static constexpr int dimension;
//   SurfacePoint<dimension> closest(const Vec<dimension>&) const;
//   Box<dimension> bounds() const;  double volume() const;  std::string describe() const;
// and either `chord`, if it is convex (convex_rows.hpp), or
//   void classify(std::span<const Row<dimension>>, const Vec<dimension>& step, double near,
//                 RowRuns&) const;
#pragma once

#include "geometry/convex_rows.hpp"
#include "geometry/geometry.hpp"

#include <cmath>
#include <utility>

namespace plenum {

template <class Shape>
class Analytic final : public Geometry<Shape::dimension> {
 public:
  static constexpr int dimension = Shape::dimension;
  using Point = Vec<dimension>;
  using Geometry<dimension>::signedDistance;
  using Geometry<dimension>::closest;

  explicit Analytic(Shape shape) : shape_(std::move(shape)) {}

  void signedDistance(std::span<const Point> points, std::span<double> result) const override {
    for (std::size_t k = 0; k < points.size(); ++k)
      result[k] = shape_.closest(points[k]).signedDistance;
  }

  void closest(std::span<const Point> points,
               std::span<SurfacePoint<dimension>> result) const override {
    for (std::size_t k = 0; k < points.size(); ++k) result[k] = shape_.closest(points[k]);
  }

  std::unique_ptr<const RowClassifier<dimension>> rowClassifier(const Point& step,
                                                                double near) const override {
    return std::make_unique<const Rows>(shape_, step, near);
  }

  Box<dimension> bounds() const override { return shape_.bounds(); }
  Measure volume() const override { return {shape_.volume(), 0}; }
  std::string describe() const override { return shape_.describe(); }

  const Shape& shape() const { return shape_; }

 private:
  class Rows final : public RowClassifier<dimension> {
   public:
    Rows(const Shape& shape, const Point& step, double near)
        : shape_(shape), step_(step), near_(near) {}

    void classify(std::span<const Row<dimension>> rows, RowRuns& runs) const override {
      if constexpr (requires { shape_.chord(step_, step_, near_); })
        classifyConvex(shape_, rows, step_, near_, runs);
      else
        shape_.classify(rows, step_, near_, runs);
    }

   private:
    const Shape& shape_;
    Point step_;
    double near_;
  };

  Shape shape_;
};

template <class Shape>
GeometryPtr<Shape::dimension> makeGeometry(Shape shape) {
  return std::make_shared<const Analytic<Shape>>(std::move(shape));
}

/// The unit vector along `a`, or `fallback` where `a` has no direction.
template <int Dim>
Vec<Dim> direction(const Vec<Dim>& a, const Vec<Dim>& fallback) {
  const double length = norm(a);
  return length > 0 ? a / length : fallback;
}

template <int Dim>
Vec<Dim> unitVector(int axis) {
  Vec<Dim> e;
  e[axis] = 1;
  return e;
}

}  // namespace plenum
