// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/generate.hpp"

#include "ictools/ic_settings.hpp"
#include "particles/particle_file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <set>

namespace plenum {
namespace {

TEST(Generate, NumbersWallsFirstAndEverybodyOnce) {
  const Scene<2> scene = test::sceneOf<2>(test::shaftCase());
  const auto id = scene.particles[field::id];
  EXPECT_EQ(std::set<std::uint64_t>(id.begin(), id.end()).size(), 2083u);
  EXPECT_EQ(id[0], 872u);
  EXPECT_EQ(id[1212], 1u);
  EXPECT_EQ(scene.info.walls.size(), 2u);
  EXPECT_EQ(scene.info.walls[0].name, "shaft");
  EXPECT_DOUBLE_EQ(scene.info.walls[0].thickness, 0.04);
  EXPECT_EQ(scene.info.materials.at(0).name, "gap");
  EXPECT_DOUBLE_EQ(scene.info.smoothingLength, 0.0075);
  for (const double h : scene.particles[field::smoothingLength]) EXPECT_DOUBLE_EQ(h, 0.0075);
  for (const Vec<2>& x : scene.particles[field::position])
    EXPECT_TRUE(scene.info.domain.contains(x));
}

TEST(Generate, TheSameBitsForOneAndTwoThreads) {
  for (const std::string wall : {"", "method = \"conformal\""}) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const Scene<2> one = test::sceneOf<2>(test::shaftCase(wall));
    omp_set_num_threads(2);
    const Scene<2> two = test::sceneOf<2>(test::shaftCase(wall));
    omp_set_num_threads(before);
    EXPECT_TRUE(std::ranges::equal(one.particles[field::position], two.particles[field::position]));
    EXPECT_TRUE(std::ranges::equal(one.particles[field::mass], two.particles[field::mass]));
    EXPECT_EQ(one.info.container.counts, two.info.container.counts);
  }
}

TEST(Generate, QualityFiguresSayWhatWasMade) {
  const Scene<2> scene = test::sceneOf<2>(test::periodicBox("0.05", "name = \"gas\"\n"));
  const auto figure = [&](const std::string& name) {
    for (const auto& [key, value] : scene.info.quality)
      if (key == name) return value;
    ADD_FAILURE() << name;
    return 0.0;
  };
  EXPECT_EQ(figure("fluid particles"), 20 * 24);
  EXPECT_NEAR(figure("gas: mass"), 1, 1e-12);  // whole periods: cell mass is exact too
  const double stretch = 1.0 / 12 / (0.05 * std::sqrt(3.0));
  EXPECT_NEAR(figure("gas: spacing along y / asked for - 1"), stretch - 1, 1e-12);
  EXPECT_NE(describe(scene).find("480 particles"), std::string::npos);
  // Half a column and a squeezed row: the nearest neighbour.
  EXPECT_NEAR(figure("smallest distance / d_ref"), std::hypot(0.5, stretch * std::sqrt(3.0) / 2),
              1e-12);
}

TEST(Generate, TheFileHoldsTheCaseAsItWasUsed) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path() / "shaft.toml";
  std::ofstream(path) << "# a comment\n" << test::shaftCase();
  CaseNode root = CaseNode::load(path);
  const auto textOf = [&] {
    return plenum::generate<2>(root, readCase(root), path, [](const auto&) {}).scene.info.caseText;
  };
  EXPECT_TRUE(textOf().starts_with("# a comment"));
  root.set("solver.smoothing_length", "1.2");
  root.set("title", "with \"quotes\"");
  const CaseNode again = CaseNode::parse(textOf(), "again");
  // Values that are no tables stand in front of those that are.
  ASSERT_EQ(again.asTable().size(), root.asTable().size());
  for (const auto& [key, node] : root.asTable()) {
    ASSERT_NE(again.find(key), nullptr) << key;
    EXPECT_EQ(again.find(key)->printed(), node.printed());
  }
}

TEST(Generate, SurvivesTheParticleFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path() / "shaft.hdf";
  const Scene<2> scene = test::sceneOf<2>(test::shaftCase());
  writeParticleFile(path, scene);
  const Scene<2> read = readParticleFile<2>(path);
  EXPECT_TRUE(
      std::ranges::equal(read.particles[field::position], scene.particles[field::position]));
  EXPECT_TRUE(std::ranges::equal(read.particles[field::normal], scene.particles[field::normal]));
  EXPECT_EQ(read.info.container.counts, scene.info.container.counts);
}

TEST(Generate, OneDimensionWithWalls) {
  const Scene<1> scene = test::sceneOf<1>(R"(
dimension = 1
spacing = 0.1
[geometry]
tube = { box = { lower = [0], upper = [1] } }
[[fluid]]
region = "tube"
[[wall]]
outside = "tube"
)");
  EXPECT_EQ(scene.particles.nFluid(), 10u);
  EXPECT_EQ(scene.particles.nWalls(), 6u);
  for (const double r : test::nearestDistances(scene.particles[field::position], scene.info.domain))
    EXPECT_NEAR(r, 0.1, 1e-14);
}

TEST(Generate, VelocityAndPressureByFormulas) {
  const std::string solver = "[solver]\nsound_speed = 10\nbackground_pressure = 3\n";
  const Scene<2> scene = test::sceneOf<2>(test::periodicBox("0.1", R"(
lattice = "square"
density = 2
velocity_formula = ["-cos(2*pi*x)*y", "x + 2*y"]
pressure_formula = "5 + x*y")") + "\n" + solver);
  const ParticleSet<2>& p = scene.particles;
  ASSERT_EQ(p.nFluid(), 100u);
  for (std::size_t i = 0; i < p.nFluid(); ++i) {
    const auto [x, y] = p[field::position][i].components;
    // The same few operations of numbers of about 1, at most in another order.
    EXPECT_NEAR(p[field::velocity][i][0], -std::cos(2 * std::numbers::pi * x) * y, 1e-15);
    EXPECT_NEAR(p[field::velocity][i][1], x + 2 * y, 1e-15);
    EXPECT_NEAR(p[field::pressure][i], 5 + x * y, 1e-15);
    EXPECT_NEAR(p[field::density][i], 2 * (1 + (2 + x * y) / 200), 1e-15);
    EXPECT_NEAR(p[field::mass][i], p[field::density][i] * 0.01, 1e-17);
  }
}

TEST(Generate, BadFormulasAreRefused) {
  const auto expect = [](const std::string& fluid, const char* part) {
    const std::string message = test::messageOf<2>(test::periodicBox("0.1", fluid));
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  expect("velocity_formula = [\"x\"]", "needs 2 formulas, one for each axis; has 1");
  expect("velocity_formula = [\"x\", \"z\"]", "names: x, y, r, pi");
  expect("velocity_formula = [\"x\", \"1/(x-x)\"]", "it must be finite everywhere");
  expect("velocity = [1, 0]\nvelocity_formula = [\"x\", \"y\"]", "excludes velocity");
  expect("pressure_formula = \"1 +\"", "names: x, y, r, pi");
  expect("pressure_formula = \"-1000\"", "has no density at sound speed 10 m/s");
  expect("pressure = 1\npressure_formula = \"1\"", "excludes pressure, hydrostatic and profile");
  expect("pressure_formula = \"1\"\nprofile = { formula = \"1\" }", "excludes pressure");
}

/// Walls keep the pressure that the case gives with "initial", and only there or where they follow
/// the equation of state does it have an effect.
TEST(Generate, PressuresOfWallsNeedAWallThatHasOne) {
  const auto tank = [](const std::string& wallPressure) {
    return R"(
dimension = 2
spacing = 0.1
[geometry]
tank = { box = { lower = [0, 0], upper = [1, 1] } }
[[fluid]]
region = "tank"
density = 1000
[[wall]]
outside = "tank"
hydrostatic = { surface = 1 }
[solver]
gravity = [0, -10]
sound_speed = 30
wall_pressure = ")" +
           wallPressure + "\"\n";
  };
  for (const char* kept : {"initial", "equation_of_state"}) {
    const Scene<2> scene = test::sceneOf<2>(tank(kept));
    const auto pressure = scene.particles[field::pressure].subspan(scene.particles.nFluid());
    EXPECT_GT(std::ranges::max(pressure), 1e4);  // below the bottom, 1 m deep
  }
  for (const char* other : {"zero", "extrapolated"}) {
    const std::string message = test::messageOf<2>(tank(other));
    EXPECT_NE(message.find(std::string("solver.wall_pressure = \"") + other), std::string::npos)
        << message;
  }
}

TEST(Generate, HelpNamesEveryTable) {
  std::string text;
  for (const SectionDoc& doc : caseDocs()) text += doc.printed();
  for (const char* word :
       {"solver", "lattice_origin", "lattice_of", "rotation", "disk", "hydrostatic", "d_ref"})
    EXPECT_NE(text.find(word), std::string::npos);
}

}  // namespace
}  // namespace plenum
