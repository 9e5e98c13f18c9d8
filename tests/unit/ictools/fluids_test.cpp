// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/state.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

namespace plenum {
namespace {

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

const std::string gasBox =
    test::periodicBox("0.05", "lattice = \"random\"\nmass = \"exact\"\nseed = 3\n");

TEST(Fluids, GasBox) {
  const Scene<2> scene = test::sceneOf<2>(gasBox);
  EXPECT_EQ(scene.particles.nFluid(), 462u);  // 1/(sqrt(3)/2 d_ref^2) = 461.88
  EXPECT_EQ(scene.particles.nWalls(), 0u);
  EXPECT_NEAR(sum(scene.particles[field::mass]), 1, 1e-12);  // round-off of 462 additions
  EXPECT_TRUE(scene.info.container.empty());
  for (const Vec<2>& x : scene.particles[field::position])
    EXPECT_TRUE(x[0] >= 0 && x[0] < 1 && x[1] >= 0 && x[1] < 1);
}

TEST(Fluids, SeedsDiffer) {
  const auto a = test::sceneOf<2>(gasBox);
  const auto b = test::sceneOf<2>(gasBox);
  std::string other = gasBox;
  other.replace(other.find("seed = 3"), 8, "seed = 4");
  const auto c = test::sceneOf<2>(other);
  EXPECT_TRUE(std::ranges::equal(a.particles[field::position], b.particles[field::position]));
  EXPECT_FALSE(std::ranges::equal(a.particles[field::position], c.particles[field::position]));
}

TEST(Fluids, ExactMassIsDensityTimesVolume) {
  const Scene<2> scene = test::sceneOf<2>(R"(
dimension = 2
spacing = 0.013
[geometry]
gap = { annulus = { center = [0.3, 0.2], inner_radius = 0.2, outer_radius = 0.5 } }
[[fluid]]
region = "gap"
density = 998.2
mass = "exact"
)");
  const double whole = 998.2 * std::numbers::pi * (0.25 - 0.04);
  EXPECT_NEAR(sum(scene.particles[field::mass]) / whole, 1, 1e-12);  // round-off of the additions
}

TEST(Fluids, CellMassIsDensityTimesCell) {
  const Scene<3> scene = test::sceneOf<3>(R"(
dimension = 3
spacing = 0.1
[geometry]
ball = { ball = { center = [0, 0, 0], radius = 0.5 } }
[[fluid]]
region = "ball"
lattice = "fcc"
density = 2
)");
  for (const double m : scene.particles[field::mass])
    EXPECT_DOUBLE_EQ(m, 2 * 1e-3 / std::sqrt(2.0));
}

TEST(Fluids, HydrostaticStateFollowsTheFormulas) {
  const std::string text = R"(
dimension = 2
spacing = 0.02
[domain]
lower = [0, 0]
upper = [0.2, 1]
periodic = ["x"]
[geometry]
column = { box = { lower = [0, 0], upper = [0.2, 1] } }
ground = { half_space = { point = [0, 0], normal = [0, 1] } }
[[fluid]]
region = "column"
density = 1000
hydrostatic = { surface = 1 }
[[wall]]
region = "ground"
hydrostatic = { surface = 1 }
[solver]
gravity = [0, -9.81]
sound_speed = 30
wall_pressure = "equation_of_state"
)";
  const Scene<2> scene = test::sceneOf<2>(text);
  const auto& particles = scene.particles;
  EXPECT_GT(particles.nWalls(), 20u);
  const double cell =
      std::sqrt(3.0) / 2 * 0.02 * 0.02;  // 0.2 m is ten spacings: nothing is stretched
  for (std::size_t i = 0; i < particles.size(); ++i) {
    // dp/ddepth = rho g with p = c^2 (rho - rho_0)
    const double rho = 1000 * std::exp(9.81 * (1 - particles[field::position][i][1]) / 900);
    const double p = 900 * (rho - 1000);
    EXPECT_NEAR(particles[field::pressure][i], p, 1e-11 * 1e4);  // round-off of 1e4 Pa
    EXPECT_NEAR(particles[field::density][i], rho, 1e-12 * 1e3);
    EXPECT_NEAR(particles[field::mass][i], rho * cell, 1e-12);
  }
}

TEST(Fluids, HydrostaticPressureCarriesTheWeightAboveIt) {
  SolverSettings solver;
  solver.soundSpeed = 20;
  solver.gravity = {0, -9.81};
  solver.taitExponent = 7;
  const CaseNode table = CaseNode::parse("", "test.toml");
  const InitialState state(solver, 1000, {}, HydrostaticSettings{2, 5e4}, table);
  EXPECT_NEAR(state(Vec<2>{{0, 2}}).pressure, 5e4, 1e-6);
  double weight = 5e4;
  constexpr int n = 4000;
  for (int k = 0; k < n; ++k)
    weight += 9.81 * (2.0 / n) * state(Vec<2>{{0, 2 - (k + 0.5) * 2 / n}}).density;
  // Midpoint rule: off by 2^3 |g rho''|/(24 n^2).
  EXPECT_NEAR(state(Vec<2>{}).pressure, weight, 1e-5);
}

TEST(Fluids, DensityAnswersTheTaitEquation) {
  SolverSettings solver;
  solver.soundSpeed = 20;
  solver.backgroundPressure = 7;
  solver.taitExponent = 7;
  const CaseNode table = CaseNode::parse("", "test.toml");
  const InitialState state(solver, 1000, 5e4, {}, table);
  const FluidState here = state(Vec<2>{});
  const double p = 7 + 1000 * 400 / 7.0 * (std::pow(here.density / 1000, 7) - 1);  // [C] (2.4)
  EXPECT_NEAR(p, 5e4, 1e-12 * 7 * 4e5);  // round-off of c^2 rho, times the exponent
  EXPECT_DOUBLE_EQ(InitialState(solver, 1000, {}, {}, table)(Vec<1>{}).density, 1000);
  EXPECT_THROW(InitialState(solver, 1000, -1e6, {}, table)(Vec<1>{}), InputError);
}

const std::string twoFluids = R"(
dimension = 2
spacing = 0.1
[domain]
lower = [0, 0]
upper = [1.6, 1]
periodic = ["x"]
[geometry]
lower = { box = { lower = [0, 0], upper = [1.6, 0.5] } }
upper = { box = { lower = [0, 0.5], upper = [1.6, 1] } }
all = { box = { lower = [0, 0], upper = [1.6, 1] } }
[solver]
smoothing_length = 1.5
[[fluid]]
name = "water"
region = "lower"
lattice = "square"
lattice_origin = [0, 0]
velocity = [1, 2]
[[fluid]]
name = "air"
region = "upper"
lattice = "square"
lattice_origin = [0, 0]
)";

TEST(Fluids, TheFaceBetweenTwoFluidsBelongsToTheFirst) {
  // Rows at 0.1 ... 0.9: those at 0 and 1 lie on the surface; x = 0 is a periodic face.
  const Scene<2> scene = test::sceneOf<2>(twoFluids);
  const auto material = scene.particles[field::material];
  EXPECT_EQ(std::count(material.begin(), material.end(), 0), 16 * 5);
  EXPECT_EQ(std::count(material.begin(), material.end(), 1), 16 * 4);
  for (std::size_t i = 0; i < material.size(); ++i)
    EXPECT_EQ(scene.particles[field::velocity][i], (material[i] == 0 ? Vec<2>{{1, 2}} : Vec<2>{}));
  for (const double r : test::nearestDistances(scene.particles[field::position], scene.info.domain))
    EXPECT_NEAR(r, 0.1, 1e-14);
}

TEST(Fluids, TheFirstOfTwoOverlappingFluidsStands) {
  std::string text = twoFluids;
  text.replace(text.find("region = \"upper\""), 16, "region = \"all\"  ");
  const Scene<2> scene = test::sceneOf<2>(text);
  EXPECT_EQ(scene.particles.nFluid(), 16u * 9);
  for (const double r : test::nearestDistances(scene.particles[field::position], scene.info.domain))
    EXPECT_NEAR(r, 0.1, 1e-14);
}

TEST(Fluids, JitterStaysWithinItsAmplitude) {
  const std::string text = test::periodicBox("0.1", "lattice = \"square\"\n");
  const Scene<2> still = test::sceneOf<2>(text);
  const Scene<2> moved = test::sceneOf<2>(text + "jitter = 0.02\n");
  double largest = 0, mean = 0;
  for (std::size_t i = 0; i < still.particles.size(); ++i)
    for (int a = 0; a < 2; ++a) {
      const double shift =
          moved.particles[field::position][i][a] - still.particles[field::position][i][a];
      largest = std::max(largest, std::abs(shift));
      mean += shift / 200;
    }
  EXPECT_LE(largest, 0.002 * (1 + 1e-12));
  EXPECT_GT(largest, 0.0018);  // of 200 uniform numbers some come within a tenth of the end
  EXPECT_LT(std::abs(mean), 4 * 8.2e-5);  // four standard deviations of the mean: .002/sqrt(3*200)
}

TEST(Fluids, JitterKeepsOutOfEarlierFluids) {
  // The second fluid's region covers the first one's, so its own surface is not between them.
  std::string text = twoFluids;
  text.replace(text.find("region = \"upper\""), 16, "region = \"all\"  ");
  const Scene<2> scene = test::sceneOf<2>(text + "jitter = 0.5\n");
  const auto material = scene.particles[field::material];
  std::size_t nNear = 0;
  for (std::size_t i = 0; i < material.size(); ++i) {
    if (material[i] == 0) continue;
    const double y = scene.particles[field::position][i][1];
    EXPECT_GT(y, 0.5);
    if (y < 0.58) ++nNear;
  }
  EXPECT_GT(nNear, 0u);  // some of the row at 0.6 were moved towards it
}

TEST(Fluids, TheNoiseOfTwoFluidsHasNothingInCommon) {
  const std::string seeded = "mass = \"exact\"\nseed = 3\n";
  const std::string second = "[[fluid]]\nname = \"b\"\nlattice = \"random\"\nregion = \"right\"\n";
  const std::string text = R"(
dimension = 2
spacing = 0.05
[geometry]
left = { box = { lower = [0, 0], upper = [1, 1] } }
right = { box = { lower = [2, 0], upper = [3, 1] } }
[[fluid]]
name = "a"
lattice = "random"
region = "left"
)";
  const Scene<2> both = test::sceneOf<2>(text + seeded + second + seeded);
  const auto x = both.particles[field::position];
  const std::size_t n = both.particles.nFluid() / 2;
  ASSERT_EQ(both.particles.nFluid(), 2 * n);
  double product = 0;
  for (std::size_t i = 0; i < n; ++i)
    product += (x[i][0] - 0.5) * (x[n + i][0] - 2.5) * 12 / static_cast<double>(n);
  EXPECT_LT(std::abs(product), 4 / std::sqrt(static_cast<double>(n)));  // four standard deviations
  // The first fluid has the numbers of its seed, as the fluid of the gas box.
  const auto alone = test::sceneOf<2>(gasBox).particles;
  for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(x[i], alone[field::position][i]);
}

}  // namespace
}  // namespace plenum
