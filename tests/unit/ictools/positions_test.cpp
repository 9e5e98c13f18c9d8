// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/positions.hpp"

#include "ictools/check.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

namespace plenum {
namespace {

/// Cases beside a file of points.
class Positions : public ::testing::Test {
 protected:
  void points(const std::string& text) { std::ofstream(folder_.path() / "p.csv") << text; }

  /// A box of 1 m, or the periodic domain of that size, with more keys of its fluid.
  std::string box(const std::string& more = "") const {
    return "dimension = 2\nspacing = 0.5\n[geometry]\n"
           "tank = { box = { lower = [0, 0], upper = [1, 1] } }\n[solver]\nsmoothing_length = 1.2\n"
           "[[fluid]]\nname = \"gas\"\nregion = \"tank\"\npositions = { file = \"p.csv\" }\n" +
           more;
  }
  std::string periodic() const {
    return "dimension = 2\nspacing = 0.1\n[domain]\nlower = [0, 0]\nupper = [1, 1]\n"
           "periodic = [\"x\", \"y\"]\n[[fluid]]\nname = \"gas\"\n"
           "positions = { file = \"p.csv\" }\n";
  }
  std::string caseFile() const { return folder_.path() / "test.toml"; }
  Scene<2> scene(const std::string& text) const {
    return test::sceneOf<2>(text, nullptr, caseFile());
  }
  std::string messageOf(const std::string& text) const {
    try {
      scene(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  void expectError(const std::string& text, const std::string& part) const {
    const std::string message = messageOf(text);
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }

  test::TemporaryFolder folder_;
};

TEST_F(Positions, StandWhereTheFileHasThemWithTheMassOfTheRegion) {
  points("0.2,0.3\n0.7,0.1\n0.9,0.8\n0.4,0.6\n");
  const Scene<2> made = scene(box("density = 6\n"));
  const auto x = made.particles[field::position];
  ASSERT_EQ(x.size(), 4u);
  EXPECT_EQ(x[0], (Vec<2>{{0.2, 0.3}}));
  EXPECT_EQ(x[3], (Vec<2>{{0.4, 0.6}}));
  for (const double m : made.particles[field::mass]) EXPECT_DOUBLE_EQ(m, 1.5);  // 6 * 1 m^2 / 4
  // d_ref's closest packing on request: 6 sqrt(3)/2 d_ref^2.
  EXPECT_DOUBLE_EQ(scene(box("density = 6\nmass = \"cell\"\n")).particles[field::mass][0],
                   6 * std::sqrt(3.0) / 2 * 0.25);
}

TEST_F(Positions, AreScaledThenMoved) {
  points("200,300\n");
  const auto made = scene(box("").replace(box().find("\"p.csv\""), 7,
                                          "\"p.csv\", scale = 1e-3, translate = [0.5, -0.25]"));
  EXPECT_DOUBLE_EQ(made.particles[field::position][0][0], 0.7);
  // 0.3 - 0.25 is rounded in units of 0.3: 5.6e-17
  EXPECT_NEAR(made.particles[field::position][0][1], 0.05, 6e-17);
}

TEST_F(Positions, OutsideOfTheRegionAreCounted) {
  points("0.2,0.3\n0.5,1.25\n0.5,1.5\n0.5,0.5\n");
  expectError(box(),
              "2 of 4 points lie outside of the region of fluid \"gas\", the furthest at (0.5, "
              "1.5), 0.5 m away");
  expectError(box(), "test.toml:10: ");
  expectError(box(), "set scale");
}

TEST_F(Positions, OnTheSurfaceAreInside) {
  points("0,0\n1,0.5\n0.5,0.5\n");
  EXPECT_EQ(scene(box()).particles.size(), 3u);
  // 1e-6 d_ref is the round-off of a surface; ten times of it is not.
  points("0,0\n1.000005,0.5\n0.5,0.5\n");
  expectError(box(), "1 of 3 points");
}

TEST_F(Positions, OnThePeriodicFaceAreOnTheOther) {
  points("0.5,1\n0.5,0.5\n");
  const Scene<2> made = scene(periodic());
  EXPECT_EQ(made.particles[field::position][0], (Vec<2>{{0.5, 0}}));
  points("0.5,1\n0.5,0\n0.5,0.5\n");
  expectError(periodic(), "2 of 3 points share their place with another, the first at (0.5, 0)");
  points("0.5,1.2\n0.5,0.5\n");
  expectError(periodic(), "1 of 2 points lie outside of the periodic domain");
}

TEST_F(Positions, ExcludeLattices) {
  points("0.5,0.5\n");
  expectError(box("lattice = \"square\"\n"), "lattice = \"square\": excludes positions");
  expectError(box("lattice_origin = [0, 0]\n"), "excludes positions");
  expectError(box("profile = { formula = \"1\" }\n"), "equal_spacing");
  EXPECT_EQ(messageOf(box("profile = { formula = \"1\" }\nparticles = \"equal_spacing\"\n")), "");
}

TEST_F(Positions, LeaveTheFluidBeforeItsPlace) {
  points("0.25,0.25\n0.75,0.75\n");
  const std::string second = box("mass = \"cell\"\n");
  const std::string text = fmt::format(
      "{}[[fluid]]\nname = \"first\"\nregion = \"left\"\nlattice = \"square\"\n{}",
      second.substr(0, second.find("[[fluid]]")), second.substr(second.find("[[fluid]]")));
  std::string twoRegions = text;
  twoRegions.insert(twoRegions.find("tank ="),
                    "left = { box = { lower = [0, 0], upper = [0.5, 0.5] } }\n");
  const Scene<2> made = scene(twoRegions);
  ASSERT_EQ(made.particles.size(), 2u);  // one of the lattice, one of the file
  EXPECT_EQ(made.particles[field::position][1], (Vec<2>{{0.75, 0.75}}));
}

TEST_F(Positions, NeedAFileThatHasPoints) {
  points("x,y\n");
  expectError(box(), "holds no points");
  points("x,y,type\n0.5,0.5,1\n");
  expectError(box(), "its 1 particles are walls");
  points("x,y,z\n0.5,0.5,1\n0.6,0.6,1\n");
  EXPECT_EQ(messageOf(box()), "");
  points("x,y,z\n0.5,0.5,1\n0.6,0.6,1.1\n");
  expectError(box(), "point 2 has z = 1.1, the first point 1");
  std::filesystem::remove(folder_.path() / "p.csv");
  expectError(box(), "no such file");
}

TEST_F(Positions, AreCheckedAndCountedByCheck) {
  points("0.2,0.3\n0.7,0.1\n0.9,0.8\n");
  std::ofstream(caseFile()) << box();
  const CheckReport sound = checkCase(caseFile(), {});
  EXPECT_FALSE(sound.findings.hasErrors());
  EXPECT_EQ(sound.estimate.value().nFluid, 3);
  points("0.2,0.3\n0.7,3\n");
  EXPECT_TRUE(checkCase(caseFile(), {}).findings.hasErrors());
}

}  // namespace
}  // namespace plenum
