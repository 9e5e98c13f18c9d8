// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/box_shape.hpp"
#include "geometry/placement.hpp"
#include "geometry/round_shapes.hpp"
#include "probe.hpp"

#include <numbers>

namespace plenum::test {
namespace {

constexpr double pi = std::numbers::pi;

template <int Dim>
Box<Dim> around(double half) {
  return {Vec<Dim>::filled(-half), Vec<Dim>::filled(half), {}};
}

template <int Dim>
void expectShape(const GeometryPtr<Dim>& shape, const Member<Dim>& member, double half = 2) {
  expectTrueDistances(*shape, member, around<Dim>(half), 2000);
  expectUnitGradient(*shape, around<Dim>(half), 2000);
  EXPECT_EQ(shape->tolerance(), 0);
  EXPECT_FALSE(shape->describe().empty());
}

TEST(Shapes, IntervalIsABoxInOneDimension) {
  const auto interval = makeGeometry(BoxShape<1>{{{{-0.5}}, {{1.5}}, {}}});
  expectShape<1>(interval, [](const Vec<1>& x) { return x[0] > -0.5 && x[0] < 1.5; });
  EXPECT_EQ(interval->volume().value, 2);
}

TEST(Shapes, Box) {
  const Box<2> flat{{{-0.5, -1}}, {{1, 0.25}}, {}};
  expectShape<2>(makeGeometry(BoxShape<2>{flat}),
                 [&](const Vec<2>& x) { return flat.contains(x); });
  const Box<3> solid{{{-0.5, -1, 0.1}}, {{1, 0.25, 0.7}}, {}};
  const auto box = makeGeometry(BoxShape<3>{solid});
  expectShape<3>(box, [&](const Vec<3>& x) { return solid.contains(x); });
  EXPECT_DOUBLE_EQ(box->volume().value, 1.5 * 1.25 * 0.6);
  EXPECT_EQ(box->volume().error, 0);
}

TEST(Shapes, DiskAndBall) {
  const auto disk = makeGeometry(Ball<2>{{{0.2, -0.1}}, 0.8});
  expectShape<2>(disk, [](const Vec<2>& x) { return norm(x - Vec<2>{{0.2, -0.1}}) < 0.8; });
  EXPECT_DOUBLE_EQ(disk->volume().value, pi * 0.64);
  const auto ball = makeGeometry(Ball<3>{{{0.2, -0.1, 0.3}}, 0.8});
  expectShape<3>(ball, [](const Vec<3>& x) { return norm(x - Vec<3>{{0.2, -0.1, 0.3}}) < 0.8; });
  EXPECT_DOUBLE_EQ(ball->volume().value, 4 * pi / 3 * 0.512);
}

TEST(Shapes, Annulus) {
  const auto annulus = makeGeometry(Annulus{{{0.1, 0.2}}, 0.5, 1.25});
  expectShape<2>(annulus, [](const Vec<2>& x) {
    const double r = norm(x - Vec<2>{{0.1, 0.2}});
    return r > 0.5 && r < 1.25;
  });
  EXPECT_DOUBLE_EQ(annulus->volume().value, pi * (1.25 * 1.25 - 0.25));
}

TEST(Shapes, CylinderOfAnyAxis) {
  const Cylinder shape{{{-0.4, -0.3, 0.2}}, {{0.8, 0.5, -0.4}}, 0.6};
  const double length = norm(shape.to - shape.from);
  const Vec<3> axis = (shape.to - shape.from) / length;
  const auto cylinder = makeGeometry(shape);
  expectShape<3>(cylinder, [&](const Vec<3>& x) {
    const double along = dot(x - shape.from, axis);
    return along > 0 && along < length && norm(x - shape.from - along * axis) < shape.radius;
  });
  EXPECT_DOUBLE_EQ(cylinder->volume().value, pi * 0.36 * length);
}

TEST(Shapes, CylinderBoundsAreTight) {
  const Box<3> box = Cylinder{{{0, 0, 0}}, {{0, 0, 2}}, 0.5}.bounds();
  EXPECT_EQ(box.lower, (Vec<3>{{-0.5, -0.5, 0}}));
  EXPECT_EQ(box.upper, (Vec<3>{{0.5, 0.5, 2}}));
}

TEST(Shapes, HalfSpaceIsUnbounded) {
  const Vec<3> normal = Vec<3>{{1, 2, -2}} / 3;
  const auto half = makeGeometry(HalfSpace<3>{{{0.1, 0.2, 0}}, normal});
  expectShape<3>(half, [&](const Vec<3>& x) { return dot(normal, x - Vec<3>{{0.1, 0.2, 0}}) < 0; });
  EXPECT_TRUE(std::isinf(half->volume().value));
  EXPECT_FALSE(half->bounds().isFinite());
  const auto floor = makeGeometry(HalfSpace<2>{{{0, 1}}, {{0, 1}}});
  EXPECT_EQ(floor->bounds().upper[1], 1);
}

TEST(Shapes, QueriesAtSingularPointsAreFinite) {
  const std::vector<GeometryPtr<3>> shapes = {makeGeometry(Ball<3>{{}, 1}),
                                              makeGeometry(BoxShape<3>{around<3>(1)}),
                                              makeGeometry(Cylinder{{{0, 0, -1}}, {{0, 0, 1}}, 1}),
                                              makeGeometry(HalfSpace<3>{{}, {{0, 0, 1}}})};
  const std::vector<Vec<3>> points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 0, 1}}, {{1, 1, 1}},
                                      {{0, 0, 5}}, {{1, 0, 1}}, {{0, 0, -1}}};
  for (const auto& shape : shapes)
    for (const Vec<3>& x : points) {
      const SurfacePoint<3> hit = shape->closest(x);
      EXPECT_DOUBLE_EQ(norm(hit.normal), 1) << shape->describe();
      EXPECT_NEAR(norm(x - hit.point - hit.signedDistance * hit.normal), 0, 1e-15);
    }
  EXPECT_EQ(makeGeometry(Ball<3>{{}, 1})->signedDistance(Vec<3>{}), -1);
  EXPECT_EQ(makeGeometry(Annulus{{}, 1, 2})->signedDistance(Vec<2>{}), 1);
}

TEST(Shapes, PlacementScalesTurnsAndMoves) {
  Placement<3> placement;
  placement.scale = 0.5;
  placement.rotate(90, {0, 0, 2});
  placement.translation = {{1, 0, 0}};
  const Vec<3> moved = placement.apply({{1, 0, 2}});
  EXPECT_NEAR(norm(moved - Vec<3>{{1, 0.5, 1}}), 0, 1e-15);
  EXPECT_NEAR(norm(placement.invert(moved) - Vec<3>{{1, 0, 2}}), 0, 1e-15);

  const Box<3> box{{{0, 0, 0}}, {{2, 1, 1}}, {}};
  const auto shape = placed(makeGeometry(BoxShape<3>{box}), placement);
  expectTrueDistances<3>(
      *shape, [&](const Vec<3>& x) { return box.contains(placement.invert(x)); }, around<3>(2),
      2000);
  EXPECT_DOUBLE_EQ(shape->volume().value, 0.25);
}

TEST(Shapes, BatchesOfAnyLengthAgreeWithSingleQueries) {
  const auto ball = makeGeometry(Ball<3>{{}, 1});
  Random<3> random;
  for (const std::size_t n : {0u, 1u, 63u, 64u, 65u, 200u}) {
    std::vector<Vec<3>> points(n);
    for (Vec<3>& x : points) x = random.inBox(around<3>(2));
    std::vector<std::uint8_t> inside(n);
    ball->inside(points, inside);
    for (std::size_t k = 0; k < n; ++k) EXPECT_EQ(inside[k] != 0, ball->isInside(points[k]));
  }
}

}  // namespace
}  // namespace plenum::test
