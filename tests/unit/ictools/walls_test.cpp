// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/walls.hpp"

#include "geometry/box_shape.hpp"
#include "geometry/round_shapes.hpp"
#include "ictools/wall_layers.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace plenum {
namespace {

constexpr double pi = std::numbers::pi;

/// Points of one layer, k = 1, 2, ...
template <int Dim>
std::vector<Vec<Dim>> layerOf(const std::vector<WallPoint<Dim>>& points, int k, double spacing) {
  std::vector<Vec<Dim>> layer;
  for (const auto& point : points)
    if (std::abs(point.depth - (k - 0.5) * spacing) < 0.01 * spacing)
      layer.push_back(point.position);
  return layer;
}

/// What every conformal wall must be: at its depth, with unit normals into the fluid, nobody nearer
/// than 0.6 d_ref.
template <int Dim>
void expectConformal(const std::vector<WallPoint<Dim>>& points, const WallSolid<Dim>& solid,
                     double spacing, int layers, const Box<Dim>& box) {
  std::vector<Vec<Dim>> positions;
  for (const auto& point : points) {
    positions.push_back(point.position);
    const double layer = point.depth / spacing + 0.5;
    EXPECT_NEAR(layer, std::round(layer), 1e-8);  // round-off over spacing, some moves
    EXPECT_GE(std::round(layer), 1);
    EXPECT_LE(std::round(layer), layers);
    EXPECT_NEAR(norm(point.normal), 1, 1e-12);
    // Half the depth on along the normal is half as deep: it points to the surface.
    const Vec<Dim> nearer = point.position + 0.5 * point.depth * point.normal;
    EXPECT_NEAR(solid.depth(solid.geometry->signedDistance(nearer)), point.depth / 2,
                1e-8 * spacing);
  }
  for (const double r : test::nearestDistances(positions, box)) {
    EXPECT_GE(r, 0.6 * spacing);
    EXPECT_LE(r, 1.4 * spacing);
  }
}

/// Neighbours along a closed layer around the origin, in order of angle.
void expectEvenAround(std::vector<Vec<2>> layer, double spacing, double smallest, double largest) {
  std::sort(layer.begin(), layer.end(), [](const Vec<2>& a, const Vec<2>& b) {
    return std::atan2(a[1], a[0]) < std::atan2(b[1], b[0]);
  });
  for (std::size_t k = 0; k < layer.size(); ++k) {
    const double step = norm(layer[k] - layer[(k + 1) % layer.size()]) / spacing;
    EXPECT_GE(step, smallest);
    EXPECT_LE(step, largest);
  }
}

TEST(ConformalWall, RingsInsideAndOutsideOfADisk) {
  const double d = 0.005;
  const auto disk = makeGeometry(Ball<2>{{{0, 0}}, 0.04});
  const Box<2> box{Vec<2>::filled(-0.07), Vec<2>::filled(0.07), {}};
  for (const bool outside : {false, true}) {
    const WallSolid<2> solid{disk, outside};
    const auto points = conformalLayers(solid, d, 4, box);
    expectConformal(points, solid, d, 4, box);
    for (int k = 1; k <= 4; ++k) {
      const double radius = 0.04 + (outside ? 1 : -1) * (k - 0.5) * d;
      const auto layer = layerOf(points, k, d);
      EXPECT_EQ(layer.size(), std::lround(2 * pi * radius / d));
      // Even: chords of equal arcs, traced with segments of d/5, whose error is (d/5)^2/(24 R^2).
      const double chord = 2 * radius / d * std::sin(pi / static_cast<double>(layer.size()));
      expectEvenAround(layer, d, chord - 0.002, chord + 0.002);
    }
    double volume = 0;
    for (const auto& point : points) volume += point.volume;
    const double inner = outside ? 0.04 : 0.02, outer = outside ? 0.06 : 0.04;
    // The layers' volumes add up to the band's; traced lengths are short by 1e-3 at most.
    EXPECT_NEAR(volume / (pi * (outer * outer - inner * inner)), 1, 1e-3);
  }
}

TEST(ConformalWall, AFullShaftIsFilledToItsCentre) {
  const auto disk = makeGeometry(Ball<2>{{{0, 0}}, 0.04});
  const WallSolid<2> solid{disk, false};
  const Box<2> box{Vec<2>::filled(-0.05), Vec<2>::filled(0.05), {}};
  const auto points = conformalLayers(solid, 0.005, 8, box);
  expectConformal(points, solid, 0.005, 8, box);
  EXPECT_EQ(layerOf(points, 8, 0.005).size(), 3u);  // 2 pi d/2 = 3.14 d
}

TEST(ConformalWall, CornersInAndOut) {
  const double d = 0.05;
  const auto square = makeGeometry(BoxShape<2>{{Vec<2>::filled(-0.5), Vec<2>::filled(0.5), {}}});
  const Box<2> box{Vec<2>::filled(-0.8), Vec<2>::filled(0.8), {}};
  for (const bool outside : {false, true}) {
    const WallSolid<2> solid{square, outside};
    const auto points = conformalLayers(solid, d, 3, box);
    expectConformal(points, solid, d, 3, box);
    for (int k = 1; k <= 3; ++k) {
      const auto layer = layerOf(points, k, d);
      // Inside: squares with a point at each corner. Outside: straight sides and quarter circles;
      // across those of the first layer, of radius d/2, a chord is short: 2 R sin(d/(2R)) = .84 d.
      const double length = outside ? 4 + 2 * pi * (k - 0.5) * d : 4 * (1 - (2 * k - 1) * d);
      EXPECT_NEAR(static_cast<double>(layer.size()), length / d, 1);
      expectEvenAround(layer, d, outside ? 0.83 : 0.97, 1.03);
      if (outside) continue;
      const double corner = 0.5 - (k - 0.5) * d;
      EXPECT_TRUE(std::any_of(layer.begin(), layer.end(), [&](const Vec<2>& x) {
        return norm(x - Vec<2>::filled(corner)) < 1e-9;
      }));
    }
  }
}

TEST(ConformalWall, SharpObtuseAndReentrantCorners) {
  for (const char* points :
       {"[[0.3, 0.3], [1.2, 0.3], [0.3, 0.9]]",  // angles of 90, 34 and 56 degrees
        "[[0.2, 0.2], [1.2, 0.2], [1.2, 0.6], [0.6, 0.6], [0.6, 1.2], [0.2, 1.2]]",
        "[[0.5, 0.2], [0.8, 0.35], [1.1, 0.2], [0.95, 0.5], [1.1, 0.8], [0.8, 0.65], [0.5, 0.8], "
        "[0.65, 0.5]]"}) {
    const Scene<2> scene = test::sceneOf<2>(std::string(R"(
dimension = 2
spacing = 0.05
[geometry]
tank = { box = { lower = [0, 0], upper = [1.5, 1.5] } }
part = { polygon = { points = )") + points + R"( } }
water = { difference = ["tank", "part"] }
[[fluid]]
region = "water"
[[wall]]
region = "part"
method = "conformal"
)");
    const auto all = scene.particles[field::position];
    const std::vector<Vec<2>> walls(
        all.begin() + static_cast<std::ptrdiff_t>(scene.particles.nFluid()), all.end());
    EXPECT_GT(walls.size(), 60u);
    for (const double r : test::nearestDistances(walls, Box<2>{})) {
      EXPECT_GE(r, 0.6 * 0.05 * (1 - 1e-9));
      EXPECT_LE(r, 1.4 * 0.05);
    }
  }
}

TEST(ConformalWall, AThinPlateHasNobodyTwice) {
  const double d = 0.05;
  for (const double thickness : {0.12, 0.15, 0.17, 0.2, 0.23}) {
    const auto plate = makeGeometry(BoxShape<2>{{{{0, 0}}, {{1, thickness}}, {}}});
    const auto points =
        conformalLayers(WallSolid<2>{plate, false}, d, 3, {{{-0.3, -0.3}}, {{1.3, 0.5}}, {}});
    EXPECT_GT(points.size(), 30u);
    std::vector<Vec<2>> positions;
    for (const auto& point : points) positions.push_back(point.position);
    for (const double r : test::nearestDistances(positions, Box<2>{}))
      EXPECT_GE(r, 0.6 * d * (1 - 1e-12));
  }
}

TEST(ConformalWall, AFloorContinuesThroughPeriodicFaces) {
  const auto ground = makeGeometry(HalfSpace<2>{{{0, 0}}, {{0, 1}}});
  const WallSolid<2> solid{ground, false};
  const Box<2> box{{{0, -0.3}}, {{0.53, 0.3}}, {true, false}};
  const auto points = conformalLayers(solid, 0.05, 3, box);
  expectConformal(points, solid, 0.05, 3, box);
  EXPECT_EQ(points.size(), 3u * 11);  // 0.53/0.05 = 10.6
  for (const auto& point : points) EXPECT_NEAR(norm(point.normal - Vec<2>{{0, 1}}), 0, 1e-12);
}

TEST(ConformalWall, ShellsOfABallAndFacesOfABox) {
  const double d = 0.1;
  const auto ball = makeGeometry(Ball<3>{{{0, 0, 0}}, 0.6});
  const auto cube = makeGeometry(BoxShape<3>{{Vec<3>::filled(-0.5), Vec<3>::filled(0.5), {}}});
  const Box<3> box{Vec<3>::filled(-1), Vec<3>::filled(1), {}};
  for (const WallSolid<3>& solid : {WallSolid<3>{ball, false}, WallSolid<3>{cube, true}}) {
    const auto points = conformalLayers(solid, d, 3, box);
    expectConformal(points, solid, d, 3, box);
    double volume = 0;
    for (const auto& point : points) {
      volume += point.volume;
      EXPECT_GT(point.volume, 0.8 * d * d * d);  // about one point a spacing squared
      EXPECT_LT(point.volume, 1.2 * d * d * d);
    }
    // Counted on a lattice of d/3: some percent of a layer whose surface it cuts unevenly.
    const double exact = solid.isOutside ? 6 * 0.3 + 12 * 0.09 * pi / 4 + 4.0 / 3 * pi * 0.027
                                         : 4.0 / 3 * pi * (0.216 - 0.027);
    EXPECT_NEAR(volume / exact, 1, 0.04);
  }
}

TEST(ConformalWall, APipeContinuesThroughPeriodicFaces) {
  const auto pipe = makeGeometry(Cylinder{{{-1, 0, 0}}, {{2, 0, 0}}, 0.3});
  const WallSolid<3> solid{pipe, true};
  const Box<3> box{{{0, -0.6, -0.6}}, {{0.72, 0.6, 0.6}}, {true, false, false}};
  const auto points = conformalLayers(solid, 0.1, 2, box);
  expectConformal(points, solid, 0.1, 2, box);  // distances across the faces too
  for (const auto& point : points) EXPECT_TRUE(point.position[0] >= 0 && point.position[0] < 0.72);
}

TEST(ConformalWall, OneDimension) {
  const auto interval = makeGeometry(BoxShape<1>{{{{0}}, {{1}}, {}}});
  const auto points =
      conformalLayers(WallSolid<1>{interval, true}, 0.1, 3, Box<1>{{{-0.5}}, {{1.5}}, {}});
  ASSERT_EQ(points.size(), 6u);
  for (const auto& point : points) {
    EXPECT_NEAR(point.volume, 0.1, 1e-12);
    EXPECT_EQ(point.normal[0], point.position[0] < 0 ? 1 : -1);
  }
}

TEST(LatticeWall, ContinuesTheFluid) {
  const Scene<2> scene = test::sceneOf<2>(test::shaftCase());
  const auto position = scene.particles[field::position];
  for (const double r : test::nearestDistances(position, scene.info.domain))
    EXPECT_NEAR(r, 0.005, 1e-15);  // one lattice through fluid and walls; round-off of 0.1
  const std::size_t nFluid = scene.particles.nFluid();
  for (std::size_t w = 0; w < scene.particles.nWalls(); ++w) {
    const Vec<2> x = position[nFluid + w];
    const double r = norm(x), depth = scene.particles[field::wallDistance][w];
    const bool isShaft = scene.particles[field::wall][w] == 0;
    EXPECT_NEAR(depth, isShaft ? 0.04 - r : r - 0.1, 1e-15);
    if (r > 0) {
      EXPECT_NEAR(norm(scene.particles[field::normal][w] - (isShaft ? 1 : -1) / r * x), 0, 1e-12);
    }
    const double omega = isShaft ? 1000 * 2 * pi / 60 : 0;
    const Vec<2> v = scene.particles[field::velocity][nFluid + w];
    EXPECT_NEAR(norm(v - omega * Vec<2>{{-x[1], x[0]}}), 0, 1e-14 * 10);  // v up to 4 m/s
    EXPECT_DOUBLE_EQ(scene.particles[field::mass][nFluid + w], std::sqrt(3.0) / 2 * 0.005 * 0.005);
  }
}

TEST(Walls, TheFirstOfTwoHasTheCorner) {
  const std::string text = R"(
dimension = 2
spacing = 0.1
[geometry]
water = { box = { lower = [0, 0], upper = [1, 1] } }
ground = { half_space = { point = [0, 0], normal = [0, 1] } }
left = { half_space = { point = [0, 0], normal = [1, 0] } }
[[fluid]]
region = "water"
lattice = "square"
[[wall]]
region = "ground"
METHOD
[[wall]]
region = "left"
METHOD
)";
  for (const std::string method : {"", "method = \"conformal\""}) {
    std::string filled = text;
    for (std::size_t at; (at = filled.find("METHOD")) != std::string::npos;)
      filled.replace(at, 6, method);
    const Scene<2> scene = test::sceneOf<2>(filled);
    const auto position = scene.particles[field::position];
    for (const double r : test::nearestDistances(position, scene.info.domain))
      EXPECT_GE(r, 0.06 * (1 - 1e-9));
    bool cornerIsFilled = false;
    for (std::size_t w = 0; w < scene.particles.nWalls(); ++w) {
      const Vec<2> x = position[scene.particles.nFluid() + w];
      EXPECT_EQ(scene.particles[field::wall][w], x[1] < 0 ? 0 : 1);
      cornerIsFilled |= norm(x - Vec<2>{{-0.25, -0.25}}) < 0.08;
    }
    EXPECT_TRUE(cornerIsFilled);
  }
}

TEST(Walls, LayersFollowTheKernelsSupport) {
  for (const auto& [h, layers] : {std::pair{1.5, 3}, {1.6, 4}, {2.0, 4}, {1.2, 3}})
    EXPECT_EQ(layersNeeded(2 * h * 0.01, 0.01), layers);
}

}  // namespace
}  // namespace plenum
