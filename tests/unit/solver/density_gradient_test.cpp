// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/density_gradient.hpp"

#include "engine/pass_of.hpp"
#include "particles/kernels.hpp"
#include "solver/pair_pass.hpp"
#include "solver/simulation.hpp"
#include "solver/terms.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/support/jittered_scene.hpp"
#include "tests/support/walled_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace plenum {
namespace {

template <class T>
class DensityGradientTest : public testing::Test {};
TYPED_TEST_SUITE(DensityGradientTest, test::Dimensions);

/// Also at the edges, where half of the neighbours are missing.
TYPED_TEST(DensityGradientTest, IsExactForALinearDensityOnAnyParticles) {
  constexpr int dim = TypeParam::value;
  Scene<dim> scene = test::jitteredScene<dim>(dim == 3 ? 8 : 16, false);
  scene.particles.add({field::densityGradient});
  Vec<dim> slope;
  for (int a = 0; a < dim; ++a) slope[a] = 0.3 - 0.2 * a;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    scene.particles[field::density][i] = 1 + dot(slope, scene.particles[field::position][i]);

  typename Engine<dim>::Options options;
  const double h = 1.5 * scene.info.spacing;
  options.support = 2 * h;
  options.precision = Precision::doubled;
  Engine<dim> engine(scene.info.domain, options);
  engine.update(scene.particles);
  const auto pass = passOf<dim>(Pass<kernel::WendlandC2, term::DensityGradient>{{}, h, {}});
  updateDensityGradient(engine, pass, scene.particles);
  for (const Vec<dim>& gradient : scene.particles[field::densityGradient])
    for (int a = 0; a < dim; ++a)
      EXPECT_NEAR(gradient[a], slope[a], 1e-12);  // sums of some dozen, divided by moments >= .1
}

/// The pass that a case gets, in its own units, against Marrone's sum written out for all pairs.
TYPED_TEST(DensityGradientTest, DiffusionIsTheSumOverAllPairs) {
  constexpr int dim = TypeParam::value;
  Scene<dim> scene = test::jitteredScene<dim>(dim == 3 ? 8 : 16, false, 0.2, 0);
  ParticleSet<dim>& p = scene.particles;
  p.add({field::densityGradient});
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p[field::density][i] = 1 + 0.3 * uniform(generator);
    for (int a = 0; a < dim; ++a) p[field::densityGradient][i][a] = 5 * uniform(generator);
  }
  SolverSettings settings;
  settings.density = "continuity";
  settings.soundSpeed = 30;
  settings.densityDiffusion = DensityDiffusionSettings{0.15};
  const double h = settings.smoothingLength * scene.info.spacing;
  typename Engine<dim>::Options options;
  options.support = 2 * h;
  options.precision = Precision::doubled;
  options.units = Units::near(h, p[field::mass][0], settings.soundSpeed);
  Engine<dim> engine(scene.info.domain, options);
  engine.update(p);
  const Phases phases(scene.info.materials, settings);
  const auto passes =
      selectPasses<dim>(settings, phases, {scene.info.spacing, false, false}, engine.units());
  engine.run(passes.density, p);

  const auto divergences = engine.sums(field::velocityDivergence);
  for (std::size_t i = 0; i < p.size(); ++i) {
    double rate = 0, summands = 0;
    for (std::size_t j = 0; j < p.size(); ++j) {
      const Vec<dim> rij = p[field::position][i] - p[field::position][j];
      if (j == i || norm(rij) >= 2 * h) continue;
      const double rhoI = p[field::density][i], rhoJ = p[field::density][j];
      const Vec<dim> psi = (2 * (rhoJ - rhoI) / normSquared(rij)) * (-rij) -
                           (p[field::densityGradient][i] + p[field::densityGradient][j]);
      const Vec<dim> gradW = Kernel<dim, kernel::WendlandC2>::F(norm(rij), h) * rij;
      const double term = 0.15 * h * 30 * p[field::mass][j] / rhoJ * dot(psi, gradW);
      rate += term;
      summands += std::abs(term);
    }
    // Some dozen summands of a dozen roundings each.
    EXPECT_NEAR(-p[field::density][i] * divergences[i], rate, 1e-13 * summands);
    EXPECT_GT(summands, 1);
  }
}

TEST(CorrectedGradient, IsZeroWhereNeighboursLieInALine) {
  EXPECT_EQ(norm(correctedGradient<2>({{1, 0}}, {{0.5, 0}}, {})), 0);
  EXPECT_EQ(norm(correctedGradient<3>({{1, 1, 0}}, {{0.5, 0.5, 0}}, {})), 0);
  EXPECT_EQ(norm(correctedGradient<2>({{NAN, 0}}, {{NAN, 1}}, {})), 0);
}

TEST(CorrectedGradient, UsesTheMixedMoments) {
  const Vec<2> two = correctedGradient<2>({{2, 1}}, {{2, 1}}, {{0.5, 0}});
  EXPECT_DOUBLE_EQ(2 * two[0] + 0.5 * two[1], 2);
  EXPECT_DOUBLE_EQ(0.5 * two[0] + two[1], 1);
  const Vec<3> x = correctedGradient<3>({{1, 2, 3}}, {{2, 3, 4}}, {{0.1, 0.2, 0.3}});  // yz, zx, xy
  EXPECT_NEAR(2 * x[0] + 0.3 * x[1] + 0.2 * x[2], 1, 1e-14);  // some roundings of numbers near 1
  EXPECT_NEAR(0.3 * x[0] + 3 * x[1] + 0.1 * x[2], 2, 1e-14);
  EXPECT_NEAR(0.2 * x[0] + 0.1 * x[1] + 4 * x[2], 3, 1e-14);
}

/// Walls that keep a density of their own are no source of it.
TEST(DensityDiffusion, TakesNothingFromWallsThatKeepTheirs) {
  for (const double walls : {0.9, 1.0, 1.1}) {
    Scene<2> scene = test::walledScene<2>(12, 0.2, 0);
    for (double& rho : scene.particles[field::density].subspan(scene.particles.nFluid()))
      rho = walls;
    SolverSettings settings;
    settings.density = "continuity";
    settings.wallPressure = "initial";
    settings.densityDiffusion = DensityDiffusionSettings{};
    Simulation<2> simulation(std::move(scene), settings);
    simulation.step(simulation.maxTimeStep());
    const auto density = simulation.particles()[field::density];
    for (std::size_t i = 0; i < simulation.particles().nFluid(); ++i) ASSERT_EQ(density[i], 1);
  }
}

/// A jump inside the fluid is smoothed, and what one side loses the other one gets.
TEST(DensityDiffusion, KeepsTheSumOfDensityBesideWalls) {
  Scene<2> scene = test::walledScene<2>(12, 0.2, 0);
  const std::size_t n = scene.particles.nFluid();
  for (std::size_t i = 0; i < n; ++i)
    scene.particles[field::density][i] = scene.particles[field::position][i][0] < 0.5 ? 1 : 1.01;
  SolverSettings settings;
  settings.density = "continuity";
  settings.wallPressure = "extrapolated";
  settings.densityDiffusion = DensityDiffusionSettings{};
  settings.precision = "double";
  Simulation<2> simulation(std::move(scene), settings);
  const auto densities = [&] {
    const auto all = simulation.particles()[field::density];
    return std::vector<double>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
  };
  const std::vector<double> before = densities();
  simulation.step(simulation.maxTimeStep());
  const std::vector<double> after = densities();
  double sum = 0, moved = 0;  // of V drho, with equal masses
  for (std::size_t i = 0; i < n; ++i) {
    sum += (after[i] - before[i]) / before[i];
    moved += std::abs(after[i] - before[i]) / before[i];
  }
  EXPECT_GT(moved, 0.02 * 0.01 * 24);  // delta cfl of the jump, for a row of twelve on each side
  EXPECT_LT(std::abs(sum), 1e-12 * static_cast<double>(n));  // rounding of so many densities near 1
}

}  // namespace
}  // namespace plenum
