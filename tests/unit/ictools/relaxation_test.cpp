// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/threads.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace plenum {
namespace {

/// Figures that a relaxed set must show: what users of such sets ask for, three to ten times of
/// what is reached.
constexpr double scatterAt64 = 0.005, scatterAt100 = 0.003, scatterIn2D = 0.005;

std::map<std::string, double> figures(const auto& scene) {
  return {scene.info.quality.begin(), scene.info.quality.end()};
}

double scatterOf(const auto& scene) {
  return figures(scene).at("relaxation: scatter of the kernel sum");
}

/// h in d_ref of a closest packing for 64 and 100 neighbours within 2h: (4 pi/3)(2h)^3 sqrt(2).
constexpr const char* h64 = "1.1053";
constexpr const char* h100 = "1.2825";

std::string box3(const std::string& h, const std::string& fluid, const std::string& relax = "") {
  return R"(
dimension = 3
spacing = 0.07
[domain]
lower = [0, 0, 0]
upper = [1, 1, 1]
periodic = ["x", "y", "z"]
[solver]
kernel = "wendland_c2"
smoothing_length = )" +
         h + "\n[relax]\n" + relax + "\n[[fluid]]\nmass = \"exact\"\n" + fluid;
}

TEST(Relaxation, EvensOutARandomSetInAPeriodicBox) {
  EXPECT_LE(scatterOf(test::sceneOf<3>(box3(h64, "lattice = \"random\""))), scatterAt64);
  EXPECT_LE(scatterOf(test::sceneOf<3>(box3(h100, "lattice = \"random\""))), scatterAt100);
  EXPECT_LE(scatterOf(test::sceneOf<2>(
                test::periodicBox("0.02", "lattice = \"random\"\nmass = \"exact\"\n[relax]\n"))),
            scatterIn2D);
}

TEST(Relaxation, EvensOutALatticeThatWasDisturbed) {
  for (const char* lattice : {"hcp", "cubic", "bcc"}) {
    const std::string fluid = std::string("jitter = 0.3\nlattice = \"") + lattice + "\"";
    EXPECT_LE(scatterOf(test::sceneOf<3>(box3(h64, fluid))), scatterAt64) << lattice;
  }
}

TEST(Relaxation, LeavesAPerfectLatticeAlone) {
  const Scene<3> scene = test::sceneOf<3>(box3(h64, "lattice = \"hcp\""));
  // hcp is stretched to fit the box by up to 4 %: its own scatter is round-off, nothing beats it.
  EXPECT_EQ(figures(scene).at("relaxation: iterations of the best state"), 0);
}

TEST(Relaxation, WorksInOneDimension) {
  const Scene<1> scene = test::sceneOf<1>(R"(
dimension = 1
spacing = 0.01
[domain]
lower = [0]
upper = [1]
periodic = ["x"]
[[fluid]]
lattice = "random"
[relax]
)");
  EXPECT_LE(scatterOf(scene), 1e-3);  // a line has one arrangement, the even one
}

const std::string ball = R"(
dimension = 3
spacing = 0.1
[geometry]
ball = { ball = { center = [1, 2, 3], radius = 0.6 } }
[[fluid]]
region = "ball"
mass = "exact"
lattice = "random"
[solver]
smoothing_length = 1.1053
[relax]
)";

TEST(Relaxation, StaysInsideABallWithWalls) {
  for (const char* method : {"lattice", "conformal"}) {
    const Scene<3> scene = test::sceneOf<3>(ball + "[[wall]]\noutside = \"ball\"\nmethod = \"" +
                                            std::string(method) + "\"\n");
    EXPECT_LE(scatterOf(scene), scatterAt64) << method;
    for (std::size_t i = 0; i < scene.particles.nFluid(); ++i)
      EXPECT_LE(norm(scene.particles[field::position][i] - Vec<3>{{1, 2, 3}}), 0.6 - 0.0099);
  }
}

TEST(Relaxation, HoldsAFreeSurface) {
  const Scene<3> scene = test::sceneOf<3>(ball);
  EXPECT_LE(scatterOf(scene), scatterAt64);
  for (const Vec<3>& x : scene.particles[field::position])
    EXPECT_LE(norm(x - Vec<3>{{1, 2, 3}}), 0.6);
  // Nobody was drawn to the surface: the outermost shell, .05 m wide, has its share of the volume
  // (1 - (.55/.6)^3 = 23 %) to within what the layers that form along the surface explain.
  const auto position = scene.particles[field::position];
  const auto outer = std::ranges::count_if(position, [](const Vec<3>& x) {
    return norm(x - Vec<3>{{1, 2, 3}}) > 0.55;
  });
  EXPECT_NEAR(static_cast<double>(outer) / static_cast<double>(position.size()), 0.23, 0.07);
}

TEST(Relaxation, KeepsTwoFluidsApart) {
  const Scene<2> scene = test::sceneOf<2>(R"(
dimension = 2
spacing = 0.02
[domain]
lower = [0, 0]
upper = [1, 1]
periodic = ["x", "y"]
[geometry]
drop = { disk = { center = [0.5, 0.5], radius = 0.25 } }
[[fluid]]
name = "drop"
region = "drop"
density = 1000
lattice = "random"
[[fluid]]
name = "gas"
density = 1
lattice = "random"
[relax]
)");
  EXPECT_LE(scatterOf(scene), 2 * scatterIn2D);  // both fluids have rounded numbers of particles
  for (std::size_t i = 0; i < scene.particles.nFluid(); ++i) {
    const double r = norm(scene.particles[field::position][i] - Vec<2>{{0.5, 0.5}});
    if (scene.particles[field::material][i] == 0)
      EXPECT_LT(r, 0.25);
    else
      EXPECT_GT(r, 0.25);
  }
}

TEST(Relaxation, FillsARegionAcrossAPeriodicFace) {
  const Scene<2> scene = test::sceneOf<2>(R"(
dimension = 2
spacing = 0.02
[domain]
lower = [0, 0]
upper = [0.4, 1]
periodic = ["x"]
[geometry]
column = { box = { lower = [0, 0], upper = [0.4, 0.5] } }
ground = { half_space = { point = [0, 0], normal = [0, 1] } }
[[fluid]]
region = "column"
lattice = "random"
mass = "exact"
[[wall]]
region = "ground"
[relax]
)");
  EXPECT_LE(scatterOf(scene), scatterIn2D);
  // No gap along the periodic face: as many within .02 m of it as within .02 m of x = .2.
  int atFace = 0, inside = 0;
  for (std::size_t i = 0; i < scene.particles.nFluid(); ++i) {
    const double x = scene.particles[field::position][i][0];
    atFace += x < 0.02 || x > 0.38;
    inside += std::abs(x - 0.2) < 0.02;
  }
  EXPECT_NEAR(atFace, inside, 14);  // of about 60: an arrangement without order scatters
}

TEST(Relaxation, KeepsTheBestStateWhereTheToleranceIsOutOfReach) {
  const CaseNode root = CaseNode::parse(
      box3(h64, "lattice = \"random\"", "tolerance = 1e-6\nmax_iterations = 30"), "test.toml");
  const auto made = generate<3>(root, readCase(root), "test.toml", [](const auto&) {});
  const RelaxationResult& result = *made.relaxation;
  EXPECT_FALSE(result.settled);
  EXPECT_EQ(result.history.size(), 31u);
  for (const RelaxationState& state : result.history)
    EXPECT_GE(state.scatter, result.best.scatter - 1e-6)  // noise of float sums
    ;
  EXPECT_EQ(scatterOf(made.scene), result.best.scatter);
  EXPECT_NE(result.reason.find("30 iterations"), std::string::npos) << result.reason;
}

TEST(Relaxation, DoesNotDependOnTheNumberOfThreads) {
  const std::string text = box3(h64, "lattice = \"random\"", "max_iterations = 20");
  const auto scenes = test::forThreads([&] { return test::sceneOf<3>(text); });
  for (const auto& scene : scenes)
    EXPECT_TRUE(std::ranges::equal(scene.particles[field::position],
                                   scenes.front().particles[field::position]));
}

TEST(Relaxation, WvtMovesEvenOutARandomSet) {
  // The method's own paper reaches .68 % in 100 iterations; so its bound is that, doubled for the
  // smaller set.
  EXPECT_LE(scatterOf(test::sceneOf<3>(
                box3(h64, "lattice = \"random\"", "method = \"wvt\"\nmax_iterations = 200"))),
            0.0136);
}

/// Two disks without walls, the second one's spacing 5^(1/2) times coarser; `gap` apart.
std::string twoDisks(double gap, bool coarseFirst) {
  const std::string fine = "[[fluid]]\nname = \"fine\"\nregion = \"a\"\ndensity = 5\n";
  const std::string coarse =
      "[[fluid]]\nname = \"coarse\"\nregion = \"b\"\nequal_mass_with = \"fine\"\n";
  return fmt::format(R"(
dimension = 2
spacing = 0.02
[geometry]
a = {{ disk = {{ center = [0, 0], radius = 0.3 }} }}
b = {{ disk = {{ center = [{}, 0], radius = 0.3 }} }}
[relax]
{}{})",
                     0.6 + gap, coarseFirst ? coarse : fine, coarseFirst ? fine : coarse);
}

TEST(Relaxation, HoldsTwoFluidsOfDifferentSpacingWhereverTheyAre) {
  // Kernels of the coarse one reach over the gap, of the fine one they do not. Far apart its worst
  // particles stand at .6 of their spacing; unheld they collapse to less than .4.
  for (const double gap : {0.09, 0.5})
    for (const bool coarseFirst : {false, true}) {
      const Scene<2> scene = test::sceneOf<2>(twoDisks(gap, coarseFirst));
      const auto& p = scene.particles;
      const auto nearest = test::nearestDistances<2>(p[field::position], scene.info.domain);
      for (std::size_t i = 0; i < p.nFluid(); ++i) {
        const double spacing = 0.02 * p[field::smoothingLength][i] / scene.info.smoothingLength;
        EXPECT_GT(nearest[i], 0.5 * spacing) << gap << ' ' << coarseFirst << ' ' << i;
      }
    }
}

}  // namespace
}  // namespace plenum
