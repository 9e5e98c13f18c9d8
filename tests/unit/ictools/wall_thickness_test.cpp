// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/wall_thickness.hpp"

#include "tests/unit/ictools/scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace plenum {
namespace {

const double d = 0.05;
/// Solids count as joined, and thicknesses are off, by surfaceRoundOff d_ref.
const double roundOff = 2 * surfaceRoundOff * d;

/// A tank of 1.2 by 1.2 m around solids, d_ref = 0.05 m, support 3 d_ref; `solids` are entries of
/// [geometry], `names` those that the tank's fluid leaves out, `walls` the [[wall]] tables.
Scene<2> tankAround(const std::string& solids, const std::string& names, const std::string& walls,
                    std::vector<std::string>* warnings = nullptr) {
  return test::sceneOf<2>(R"(
dimension = 2
spacing = 0.05
[geometry]
tank = { box = { lower = [0, 0], upper = [1.2, 1.2] } }
)" + solids + "\nwater = { difference = [\"tank\", " +
                              names + R"(] }
[[fluid]]
region = "water"
)" + walls,
                          warnings);
}

/// Thickness of the wall around one solid.
double thicknessOf(const std::string& shape, const std::string& keys = "",
                   std::vector<std::string>* warnings = nullptr) {
  const Scene<2> scene = tankAround("part = { " + shape + " }", "\"part\"",
                                    "[[wall]]\nregion = \"part\"\n" + keys, warnings);
  EXPECT_EQ(scene.info.walls.at(0).layers, 3);
  return scene.info.walls.at(0).thickness;
}

std::string plate(double thickness) {
  return fmt::format("box = {{ lower = [0.3, 0.6], upper = [0.9, {}] }}", 0.6 + thickness);
}

TEST(WallThickness, OfAPlateBetweenFluids) {
  for (const char* method : {"", "method = \"conformal\"\n"}) {
    std::vector<std::string> warnings;
    EXPECT_NEAR(thicknessOf(plate(2 * d), method, &warnings), 2 * d, roundOff);
    ASSERT_EQ(warnings.size(), 1u);
    for (const char* part : {"wall \"part\" is only 0.1 m thick at (", "support of 0.15 m",
                             "plenum-sph will refuse", "the spacing 0.03333 m or less"})
      EXPECT_NE(warnings[0].find(part), std::string::npos) << warnings[0];
    // As thick as the support, and what no layer reaches the middle of.
    EXPECT_NEAR(thicknessOf(plate(3 * d), method, &warnings), 3 * d, roundOff);
    EXPECT_DOUBLE_EQ(thicknessOf(plate(8 * d), method, &warnings), 3 * d);
    EXPECT_EQ(warnings.size(), 1u);
  }
}

TEST(WallThickness, OfTheShaftAndItsHousingIsThatOfTheirLayers) {
  for (const char* method : {"", "method = \"conformal\"\n"}) {
    std::vector<std::string> warnings;
    const Scene<2> scene = test::sceneOf<2>(test::shaftCase(method), &warnings);
    EXPECT_DOUBLE_EQ(scene.info.walls[0].thickness, 0.04);
    EXPECT_DOUBLE_EQ(scene.info.walls[1].thickness, 0.02);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
  }
}

TEST(WallThickness, OfARoundBodyIsItsDiameter) {
  const auto rod = [](double radius) {
    return fmt::format("disk = {{ center = [0.6, 0.6], radius = {} }}", radius);
  };
  EXPECT_NEAR(thicknessOf(rod(1.2 * d)), 2.4 * d, roundOff);
  EXPECT_DOUBLE_EQ(thicknessOf(rod(1.6 * d)), 3 * d);  // 3.2 d from fluid to fluid
  EXPECT_NEAR(thicknessOf("annulus = { center = [0.6, 0.6], inner_radius = 0.2, outer_radius = "
                          "0.3 }"),
              2 * d, roundOff);
}

TEST(WallThickness, TipsAreNotThin) {
  EXPECT_DOUBLE_EQ(thicknessOf("polygon = { points = [[0.2, 0.3], [1.1, 0.3], [0.2, 0.9]] }"),
                   3 * d);  // angles of 90, 34 and 56 degrees
}

TEST(WallThickness, SolidsThatTouchAreOne) {
  std::vector<std::string> warnings;
  const Scene<2> scene = tankAround(R"(
ground = { half_space = { point = [0, 0.2], normal = [0, 1] } }
cover = { box = { lower = [-1, 0.2], upper = [3, 0.3] } }
baffle = { box = { lower = [0.6, 0.3], upper = [0.7, 0.8] } }
)",
                                    "\"ground\", \"cover\", \"baffle\"",
                                    "[[wall]]\nregion = \"ground\"\n[[wall]]\nregion = \"cover\"\n"
                                    "[[wall]]\nregion = \"baffle\"\n",
                                    &warnings);
  EXPECT_DOUBLE_EQ(scene.info.walls[0].thickness, 3 * d);
  EXPECT_DOUBLE_EQ(scene.info.walls[1].thickness, 3 * d);  // 2 d of its own, then the ground
  EXPECT_NEAR(scene.info.walls[2].thickness, 2 * d, roundOff);
  EXPECT_EQ(warnings.size(), 1u);
}

TEST(WallThickness, SolidsContinueThroughPeriodicFaces) {
  const Scene<2> scene = test::sceneOf<2>(R"(
dimension = 2
spacing = 0.05
[domain]
lower = [0, 0]
upper = [1, 1]
periodic = ["x", "y"]
[geometry]
all = { box = { lower = [0, 0], upper = [1, 1] } }
left = { box = { lower = [0, 0], upper = [0.1, 1] } }
right = { box = { lower = [0.9, 0], upper = [1, 1] } }
post = { union = ["left", "right"] }
water = { difference = ["all", "post"] }
[[fluid]]
region = "water"
[[wall]]
region = "post"
)");
  EXPECT_DOUBLE_EQ(scene.info.walls[0].thickness, 3 * d);  // of the 4 d around x = 0
}

TEST(WallThickness, InSpaceAndOnALine) {
  const Scene<3> space = test::sceneOf<3>(R"(
dimension = 3
spacing = 0.1
[geometry]
tank = { box = { lower = [0, 0, 0], upper = [1, 1, 1] } }
plate = { box = { lower = [-0.2, -0.2, 0.4], upper = [1.2, 1.2, 0.6] } }
water = { difference = ["tank", "plate"] }
[[fluid]]
region = "water"
[[wall]]
region = "plate"
[[wall]]
outside = "tank"
)");
  EXPECT_NEAR(space.info.walls[0].thickness, 0.2, 2 * surfaceRoundOff * 0.1);
  EXPECT_DOUBLE_EQ(space.info.walls[1].thickness, 3 * 0.1);
  const Scene<1> line = test::sceneOf<1>(R"(
dimension = 1
spacing = 0.1
[geometry]
left = { box = { lower = [0], upper = [1] } }
right = { box = { lower = [1.2], upper = [2] } }
tubes = { union = ["left", "right"] }
[[fluid]]
region = "tubes"
[[wall]]
outside = "tubes"
)");
  EXPECT_NEAR(line.info.walls[0].thickness, 0.2, 2 * surfaceRoundOff * 0.1);
}

}  // namespace
}  // namespace plenum
