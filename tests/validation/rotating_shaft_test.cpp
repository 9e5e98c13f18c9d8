// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rotating shaft of Kruisbrink et al. 2018, figure 6: clustering and leaking at walls.
#include "tests/support/run_case.hpp"

#include <fmt/format.h>

#include <iostream>

namespace plenum {
namespace {

/// Both precisions of pairs must show the same physics.
class RotatingShaft : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Precisions, RotatingShaft, testing::Values("mixed", "double"),
                         [](const auto& run) { return std::string(run.param); });

std::vector<Figure> runShaft(test::Changes changes) {
  changes.emplace_back("solver.precision", RotatingShaft::GetParam());
  const auto row = test::runCase<2>("rotating_shaft.toml", changes);
  for (const char* name : {"left", "void1", "f.5", "f.85", "nn_min", "psi6"})
    std::cout << "  " << name << " " << valueOf(row, name) << "\n";
  return row;
}

const std::pair<std::string, std::string> withCollisions{"solver.collisions",
                                                         "{ restitution = 0.01, range = 0.85 }"};
const std::pair<std::string, std::string> conformalShaft{"wall[0].method", "conformal"};
const std::pair<std::string, std::string> conformalHousing{"wall[1].method", "conformal"};

TEST(RotatingShaftScene, HasTheParticlesOfTheSource) {
  const auto scene = test::sceneOf<2>("rotating_shaft.toml", {}).first;
  EXPECT_EQ(scene.particles.nFluid(), 1212u);
  EXPECT_EQ(scene.particles.nWalls(), 871u);
}

TEST_P(RotatingShaft, TheQuadraticWendlandKernelClustersAndLeaks) {
  const auto row = runShaft({{"solver.kernel", "wendland_quadratic"}});
  EXPECT_GT(valueOf(row, "left"), 0);
  EXPECT_GE(valueOf(row, "f.5"), 0.9);     // docs/validation.md: .975
  EXPECT_GE(valueOf(row, "void1"), 0.05);  // .169
}

/// The run is chaotic: with steps that differ by some parts in a thousand, most runs end with no
/// particle beyond the walls and some with one of 1212 (docs/validation.md). The mean over a few
/// runs says what a single one cannot.
TEST_P(RotatingShaft, TheConvexKernelKeepsAllParticlesAndLeavesNoHoles) {
  double left = 0;
  constexpr int nRuns = 4;
  for (int run = 0; run < nRuns; ++run) {
    const double step = 1e-4 * (1 - 0.002 * run);
    const auto row =
        runShaft({{"solver.kernel", "convex"}, {"solver.time_step", fmt::format("{}", step)}});
    EXPECT_LE(valueOf(row, "left"), 1);
    EXPECT_LE(valueOf(row, "f.5"), 0.06);     // .03
    EXPECT_LE(valueOf(row, "void1"), 0.005);  // 0
    left += valueOf(row, "left") / nRuns;
  }
  EXPECT_LT(left, 1);
}

TEST_P(RotatingShaft, CollisionsKeepParticlesApart) {
  const auto row = runShaft({{"solver.kernel", "wendland_c2_1d"}, withCollisions});
  EXPECT_EQ(valueOf(row, "left"), 0);
  EXPECT_EQ(valueOf(row, "f.5"), 0);
  EXPECT_GE(valueOf(row, "nn_min"), 0.5);  // .70
}

/// Both kinds of wall layers beside each other. For (1.1), which leaks, the counts are printed
/// only: one run is chaotic and its count differs from compiler to compiler.
TEST_P(RotatingShaft, ConformalWallsHoldWithTheConvexKernel) {
  std::cout << " lattice walls, wendland_c2_1d\n";
  const auto lattice = runShaft({{"solver.kernel", "wendland_c2_1d"}});
  std::cout << " conformal walls, wendland_c2_1d\n";
  const auto conformal =
      runShaft({{"solver.kernel", "wendland_c2_1d"}, conformalShaft, conformalHousing});
  std::cout << " conformal walls, convex\n";
  const auto convex = runShaft({{"solver.kernel", "convex"}, conformalShaft, conformalHousing});
  EXPECT_EQ(valueOf(convex, "left"), 0);
  EXPECT_LE(valueOf(convex, "f.5"), 0.06);
  EXPECT_LE(valueOf(convex, "void1"), 0.005);
  EXPECT_LE(valueOf(conformal, "left"), 60);  // a twentieth of all: it does not fall apart
  EXPECT_LE(valueOf(lattice, "left"), 60);
}

}  // namespace
}  // namespace plenum
