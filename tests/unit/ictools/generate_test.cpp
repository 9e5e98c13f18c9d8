// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/generate.hpp"

#include "ictools/ic_settings.hpp"
#include "particles/particle_file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <fstream>
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
  EXPECT_EQ(again.printed(), root.printed());
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

TEST(Generate, HelpNamesEveryTable) {
  std::string text;
  for (const SectionDoc& doc : caseDocs()) text += doc.printed();
  for (const char* word :
       {"solver", "lattice_origin", "lattice_of", "rotation", "disk", "hydrostatic", "d_ref"})
    EXPECT_NE(text.find(word), std::string::npos);
}

}  // namespace
}  // namespace plenum
