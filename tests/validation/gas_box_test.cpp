// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gas-filled box of Kruisbrink et al. 2018: which kernels let particles pair in 2-D. Published
// as pictures; reference figures: docs/validation.md.
#include "tests/support/run_case.hpp"

#include <iostream>

namespace plenum {
namespace {

constexpr int nSeeds = 8;

struct Box {
  double minNearest, below05, psi6, momentum;
};

/// Both precisions of pairs must show the same physics.
class GasBox : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Precisions, GasBox, testing::Values("mixed", "double"),
                         [](const auto& run) { return std::string(run.param); });

std::vector<Box> runSeeds(test::Changes changes) {
  changes.emplace_back("solver.precision", GasBox::GetParam());
  std::vector<Box> results;
  for (int seed = 1; seed <= nSeeds; ++seed) {
    test::Changes withSeed = changes;
    withSeed.push_back({"fluid[0].seed", std::to_string(seed)});
    const auto row = test::runCase<2>("gas_box.toml", withSeed);
    results.push_back({valueOf(row, "nn_min"), valueOf(row, "f.5"), valueOf(row, "psi6"),
                       std::hypot(valueOf(row, "momentum_x"), valueOf(row, "momentum_y"))});
    std::cout << "  seed " << seed << ": min nn " << results.back().minNearest << ", f.5 "
              << results.back().below05 << ", psi6 " << results.back().psi6 << ", momentum "
              << results.back().momentum << "\n";
  }
  return results;
}

/// Momentum in units of the gas's mass (1 kg/m) times its sound speed (10 m/s). Sums of pairs in
/// float round to 6e-8 of themselves, at random.
void expectMomentumConserved(const Box& box) {
  const double roundOff = std::string(GasBox::GetParam()) == "double" ? 1e-12 : 1e-6;
  EXPECT_LE(box.momentum, roundOff * 10);
}

void expectUnpaired(const test::Changes& changes) {
  for (const Box& box : runSeeds(changes)) {
    EXPECT_EQ(box.below05, 0);
    EXPECT_GE(box.minNearest, 0.75);  // docs/validation.md: .79 and more
    EXPECT_GE(box.psi6, 0.55);        // .61 and more
    expectMomentumConserved(box);
  }
}

TEST_P(GasBox, TheOneDimensionalWendlandKernelPairs) {
  double mean = 0;
  for (const Box& box : runSeeds({{"solver.kernel", "wendland_c2_1d"}})) {
    EXPECT_GE(box.below05, 0.08);
    EXPECT_LE(box.psi6, 0.45);
    expectMomentumConserved(box);
    mean += box.below05 / nSeeds;
  }
  EXPECT_GE(mean, 0.15);
  EXPECT_LE(mean, 0.35);
  std::cout << "  mean f.5 " << mean << "\n";
}

TEST_P(GasBox, TheTrueWendlandKernelDoesNotPair) {
  expectUnpaired({{"solver.kernel", "wendland_c2"}});
}

TEST_P(GasBox, TheConvexKernelDoesNotPair) { expectUnpaired({{"solver.kernel", "convex"}}); }

TEST_P(GasBox, CollisionsKeepTheOneDimensionalWendlandKernelFromPairing) {
  expectUnpaired({{"solver.kernel", "wendland_c2_1d"},
                  {"solver.collisions", "{ restitution = 0.01, range = 0.85 }"}});
}

}  // namespace
}  // namespace plenum
