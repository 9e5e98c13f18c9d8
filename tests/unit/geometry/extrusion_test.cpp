// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/extrusion.hpp"

#include "files_for_tests.hpp"
#include "geometry/box_shape.hpp"
#include "geometry/geometry_set.hpp"
#include "geometry/placement.hpp"
#include "geometry/polygon.hpp"
#include "geometry/round_shapes.hpp"
#include "probe.hpp"
#include "tests/support/named_region.hpp"

#include <numbers>

namespace plenum::test {
namespace {

constexpr double pi = std::numbers::pi;
const Box<3> surroundings{{{-2, -2, -2}}, {{2, 2, 2}}, {}};

/// Five corners, one of them reflex.
GeometryPtr<2> arrow() {
  return makePolygon({{{{{-1, -0.8}}, {{1, 0}}, {{-1, 0.9}}, {{-0.4, 0}}}, {}}}, "arrow");
}

GeometrySet<3> read(const std::string& text) {
  return GeometrySet<3>::read(*CaseNode::parse("[geometry]\n" + text, "case.toml").find("geometry"),
                              ".");
}

TEST(Extrusion, DistancesAreTrue) {
  for (const GeometryPtr<2>& base : {arrow(), makeGeometry(Annulus{{{0.1, 0.2}}, 0.5, 1.25}),
                                     makeGeometry(HalfSpace<2>{{{0.2, 0}}, {{0.6, 0.8}}})}) {
    const auto solid = extruded(base, -0.4, 0.7);
    expectTrueDistances<3>(
        *solid,
        [&](const Vec<3>& x) {
          return x[2] > -0.4 && x[2] < 0.7 && base->isInside({{x[0], x[1]}});
        },
        surroundings, 1000);
    expectUnitGradient<3>(*solid, surroundings, 1000);
  }
}

/// The same numbers from two sets of formulas: round-off of lengths about 1 m.
void expectSame(const Geometry<3>& a, const Geometry<3>& b) {
  Random<3> random;
  for (int k = 0; k < 5000; ++k) {
    const Vec<3> x = random.inBox(surroundings);
    const SurfacePoint<3> p = a.closest(x);
    const SurfacePoint<3> q = b.closest(x);
    ASSERT_NEAR(p.signedDistance, q.signedDistance, 1e-14);
    ASSERT_NEAR(norm(p.point - q.point), 0, 1e-14);
    ASSERT_NEAR(norm(p.normal - q.normal), 0, 1e-12);  // of short ways
  }
  EXPECT_EQ(a.bounds().lower, b.bounds().lower);
  EXPECT_EQ(a.bounds().upper, b.bounds().upper);
  EXPECT_NEAR(a.volume().value, b.volume().value, 1e-14);
  EXPECT_EQ(a.volume().error, 0);
}

TEST(Extrusion, OfADiskIsACylinderAndOfABoxABox) {
  expectSame(*extruded(makeGeometry(Ball<2>{{{0.25, -0.5}}, 0.75}), -0.5, 1.25),
             *makeGeometry(Cylinder{{{0.25, -0.5, -0.5}}, {{0.25, -0.5, 1.25}}, 0.75}));
  expectSame(*extruded(makeGeometry(BoxShape<2>{{{{-1, -0.5}}, {{0.25, 1}}, {}}}), -0.5, 1.25),
             *makeGeometry(BoxShape<3>{{{{-1, -0.5, -0.5}}, {{0.25, 1, 1.25}}, {}}}));
}

TEST(Extrusion, VolumeIsAreaTimesHeight) {
  EXPECT_DOUBLE_EQ(extruded(arrow(), -0.4, 0.7)->volume().value, arrow()->volume().value * 1.1);
  const auto half = extruded(makeGeometry(HalfSpace<2>{{}, {{1, 0}}}), 0, 1);
  EXPECT_TRUE(std::isinf(half->volume().value));
  EXPECT_EQ(half->bounds().upper[2], 1);
  EXPECT_EQ(half->bounds().upper[0], 0);
}

TEST(Extrusion, OnEdgesAndCornersNothingIsWrong) {
  const auto solid = extruded(makeGeometry(BoxShape<2>{{{{-1, -1}}, {{1, 1}}, {}}}), -1, 1);
  for (const Vec<3>& x : {Vec<3>{{1, 1, 1}}, {{1, 0, 0}}, {{0, 0, 1}}, {{1, 0, -1}}, {{0, 0, 0}}}) {
    const SurfacePoint<3> hit = solid->closest(x);
    EXPECT_EQ(hit.signedDistance, x == Vec<3>{} ? -1 : 0);
    EXPECT_EQ(norm(hit.normal), 1);
  }
}

TEST(Extrusion, IsReadFromACase) {
  const auto set = read(R"(
gear = { extrude = { of = { polygon = { points = [[0, 0], [2, 0], [0, 1]] }, scale = 0.5, translate = [1, 0] }, lower = 0, upper = 0.1 } }
lying = { extrude = { of = { disk = { center = [0, 0], radius = 0.5 } }, lower = 0, upper = 2 }, rotate = { axis = [0, 1, 0], angle = 90 }, translate = [1, 0, 0] }
)");
  const auto gear = regionNamed(set, "gear");
  EXPECT_DOUBLE_EQ(gear->volume().value, 0.025);
  EXPECT_TRUE(gear->isInside(Vec<3>{{1.1, 0.1, 0.05}}));
  EXPECT_FALSE(gear->isInside(Vec<3>{{0.9, 0.1, 0.05}}));
  const auto lying = regionNamed(set, "lying");  // along x from 1 to 3
  EXPECT_NEAR(lying->signedDistance(Vec<3>{{2.75, 0, 0}}), -0.25, 1e-15);
  EXPECT_NEAR(lying->volume().value, pi / 2, 1e-15);
}

TEST(Extrusion, OfAFile) {
  const auto path = writeFile("triangle.wkt", "POLYGON ((0 0, 2 0, 0 1))");
  const auto set = read("a = { extrude = { of = { file = \"" + path.string() +
                        "\", tolerance = 0.001 }, lower = -1, upper = 1 } }");
  EXPECT_DOUBLE_EQ(regionNamed(set, "a")->volume().value, 2);
  EXPECT_EQ(regionNamed(set, "a")->tolerance(), 0.001);
}

TEST(Extrusion, RefusesWhatMakesNoSense) {
  const std::string disk = "{ disk = { center = [0, 0], radius = 1 } }";
  expectError([&] { read("a = { extrude = { of = " + disk + ", lower = 1, upper = 1 } }"); },
              {"case.toml:2", "geometry.a.extrude", "is empty", "lower 1 must be smaller"});
  expectError([&] { read("a = { extrude = { of = " + disk + ", upper = 1 } }"); },
              {"'lower' is missing", "z where it begins"});
  expectError([] { read("a = { extrude = { lower = 0, upper = 1 } }"); }, {"'of' is missing"});
  expectError([] { read("a = { extrude = { of = \"disk\", lower = 0, upper = 1 } }"); },
              {"geometry.a.extrude.of", "in braces"});
  expectError(
      [] {
        read(
            "a = { extrude = { of = { ball = { center = [0, 0, 0], radius = 1 } }, lower = 0, "
            "upper = 1 } }");
      },
      {"geometry.a.extrude.of.ball", "2-D", "use disk"});
  expectError([&] { read("a = { extrude = { of = { union = [\"b\"] }, lower = 0, upper = 1 } }"); },
              {"geometry.a.extrude.of.union", "extrude each part and take the union"});
  expectError(
      [] { read("a = { extrude = { of = { file = \"none.wkt\" }, lower = 0, upper = 1 } }"); },
      {"geometry.a.extrude.of.file", "no such file"});
  expectError(
      [&] {
        GeometrySet<2>::read(*CaseNode::parse("[geometry]\na = { extrude = { of = " + disk +
                                                  ", lower = 0, upper = 1 } }",
                                              "case.toml")
                                  .find("geometry"),
                             ".");
      },
      {"'extrude' does not exist in 2-D"});
}

}  // namespace
}  // namespace plenum::test
