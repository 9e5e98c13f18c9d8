// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each term against the formula of its source, written out by hand for one pair.
#include "solver/terms.hpp"

#include "tests/unit/solver/lanes.hpp"
#include "tests/unit/solver/two_particles.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace plenum {
namespace {

using namespace test;

TEST(Terms, DensitySum) {
  const Two two = approaching();
  EXPECT_DOUBLE_EQ(sumsOf(term::DensitySum{}, two).density, 3.0 * two.W());
}

TEST(Terms, AParticleAddsItsOwnMassToItsDensityAndNothingElse) {
  Two self = approaching();
  self.j = self.i;
  self.r = {};
  EXPECT_DOUBLE_EQ(sumsOf(term::DensitySum{}, self).density, 2.0 * K::W(0, h));
  EXPECT_EQ(sumsOf(term::Continuity{}, self).velocityDivergence, 0);
  EXPECT_EQ(norm(accelerationOf(term::PressureDensitySquared{}, self)), 0);
  EXPECT_EQ(norm(accelerationOf(term::PressureDensityProduct{}, self)), 0);
  EXPECT_EQ(norm(accelerationOf(term::MonaghanViscosity{{0.8, 1.5}, 10}, self)), 0);
  EXPECT_EQ(norm(velocityChangeOf(term::Collision{0.5, 0.5}, self)), 0);
}

TEST(Terms, ContinuityRaisesTheDensityOfApproachingParticles) {
  const Two two = approaching();
  const double vDotR = 2.0 * -0.2 + 0.25 * 0.1;
  const double rate = -1.1 * sumsOf(term::Continuity{}, two).velocityDivergence;
  EXPECT_NEAR(rate, 1.1 * (3.0 / 0.9) * vDotR * two.F(), ulp * std::abs(rate) * 4);
  EXPECT_GT(rate, 0);
}

TEST(Terms, PressureForms) {
  const Two two = approaching();
  const Vec<2> squared = accelerationOf(term::PressureDensitySquared{}, two);
  const Vec<2> product = accelerationOf(term::PressureDensityProduct{}, two);
  const double F = two.F();
  for (int a = 0; a < 2; ++a) {
    const double expectedSquared = -3.0 * (5.0 / (1.1 * 1.1) - 2.0 / (0.9 * 0.9)) * F * two.r[a];
    const double expectedProduct = -3.0 * (5.0 - 2.0) / (1.1 * 0.9) * F * two.r[a];
    // Reciprocals of densities round once more than quotients: half a dozen roundings in all.
    EXPECT_NEAR(squared[a], expectedSquared, 4 * ulp * std::abs(expectedSquared));
    EXPECT_NEAR(product[a], expectedProduct, 4 * ulp * std::abs(expectedProduct));
  }
}

TEST(Terms, MonaghanViscosityActsOnApproachingPairsOnly) {
  const Two two = approaching();
  const term::MonaghanViscosity viscosity{{0.8, 1.5}, 10};
  const double mu = h * (2.0 * -0.2 + 0.25 * 0.1) / (0.05 + 0.01 * h * h);
  const double Pi = (-0.8 * 10 * mu + 1.5 * mu * mu) / 1.0;
  const Vec<2> acceleration = accelerationOf(viscosity, two);
  for (int a = 0; a < 2; ++a)
    EXPECT_NEAR(acceleration[a], -3.0 * Pi * two.F() * two.r[a],
                1e-14 * std::abs(acceleration[a]));  // a dozen roundings
  EXPECT_LT(dot(acceleration, two.i.velocity - two.j.velocity), 0) << "viscosity must brake";
  EXPECT_EQ(normSquared(accelerationOf(viscosity, receding())), 0);
}

TEST(Terms, MonaghanViscosityOfPhasesHasTheMeanOfTheSpeedsOfSound) {
  Two two = approaching();
  two.i.soundSpeed = 4;
  two.j.soundSpeed = 16;
  const Vec<2> mean = accelerationOf(term::MonaghanViscosity{{0.8, 1.5}, 10}, two);
  const Vec<2> acceleration = accelerationOf(term::MonaghanViscosityOfPhases{{0.8, 1.5}}, two);
  for (int a = 0; a < 2; ++a) EXPECT_DOUBLE_EQ(acceleration[a], mean[a]);
}

TEST(Terms, LaminarViscosityIsMorris) {
  const Two two = approaching();
  const double mu = 0.3, rSquared = 0.05;
  const Vec<2> acceleration = accelerationOf(term::LaminarViscosity{mu, 2}, two);
  for (int a = 0; a < 2; ++a) {
    // m_j (mu_i + mu_j)/(rho_i rho_j) (r.grad W)/(r^2 + .01 h^2) v_ij
    const double expected = 3.0 * 2 * mu / (1.1 * 0.9) * (rSquared * two.F()) /
                            (rSquared + 0.01 * h * h) * (two.i.velocity - two.j.velocity)[a];
    EXPECT_NEAR(acceleration[a], expected, 1e-14 * std::abs(expected));  // a dozen roundings
  }
  EXPECT_LT(dot(acceleration, two.i.velocity - two.j.velocity), 0) << "viscosity must brake";
}

TEST(Terms, LaminarViscosityOfPhasesIsTheHarmonicMean) {
  Two two = approaching();
  const auto withViscosities = [&](double muI, double muJ) {
    two.i.dynamicViscosity = muI;
    two.j.dynamicViscosity = muJ;
    return accelerationOf(term::LaminarViscosityOfPhases{}, two)[0];
  };
  const auto ofOne = [&](double mu) {
    return accelerationOf(term::LaminarViscosity{mu, 2}, two)[0];
  };
  EXPECT_DOUBLE_EQ(withViscosities(0.3, 0.3), ofOne(0.3));
  EXPECT_DOUBLE_EQ(withViscosities(0.2, 0.6), ofOne(0.3));  // 2 mu mu/(mu + mu)
  EXPECT_DOUBLE_EQ(withViscosities(0.3, 0), ofOne(0.3)) << "a wall takes that of the fluid";
  EXPECT_DOUBLE_EQ(withViscosities(0, 0.3), ofOne(0.3));
}

TEST(Terms, DensityDiffusionIsMarrone) {
  Two two = approaching();
  const double delta = 0.2, c = 7;
  two.i.densityGradient = {{0.7, -0.4}};
  two.j.densityGradient = {{-0.3, 0.9}};
  // delta h c V_j psi_ij . grad_i W_ij, psi_ij = 2 (rho_j - rho_i) r_ji/r^2 - (G_i + G_j) with
  // r_ji = (.2, -.1).
  const double along = 2 * (0.9 - 1.1) / (0.2 * 0.2 + 0.1 * 0.1);
  const Vec<2> psi{{along * 0.2 - (0.7 - 0.3), along * -0.1 - (-0.4 + 0.9)}};
  const double expected = delta * h * c * (3.0 / 0.9) * dot(psi, two.F() * Vec<2>{{-0.2, 0.1}});
  const double rate = -1.1 * sumsOf(term::DensityDiffusion{delta, c}, two).velocityDivergence;
  // A dozen roundings; the densities cancel to a fifth.
  EXPECT_NEAR(rate, expected, 5e-14 * std::abs(expected));
}

TEST(Terms, DensityDiffusionLeavesALinearDensityAlone) {
  Two two = approaching();
  const Vec<2> gradient{{0.7, -0.4}};
  two.i.densityGradient = two.j.densityGradient = gradient;
  two.j.density = two.i.density - dot(gradient, two.r);
  const term::DensityDiffusion diffusion{0.1, 10};
  // Densities of about 1 cancel: a few of their roundings, times delta c h V F/rho of about 100.
  EXPECT_NEAR(sumsOf(diffusion, two).velocityDivergence, 0, 100 * ulp);
  two.i.density += 0.1;  // denser than its neighbour: it must lose, div v > 0
  EXPECT_GT(sumsOf(diffusion, two).velocityDivergence, 0);
}

TEST(Terms, FluidAtWallWeighsByVolume) {
  const Two two = approaching();
  const Sums<double, 2> sums = sumsOf(term::FluidAtWall{}, two);
  const double weight = 3.0 / 0.9 * two.W();
  EXPECT_DOUBLE_EQ(sums.kernelSum, weight);
  EXPECT_DOUBLE_EQ(sums.pressure, -2.0 * weight);
  EXPECT_DOUBLE_EQ(sums.massMoment.rest[0], 3.0 * two.W() * two.r[0]);
  EXPECT_DOUBLE_EQ(sumsOf(term::VelocityAtWall{}, two).velocity.rest[1], 0.25 * weight);
}

TEST(Terms, ConcentrationPushesHarderFromNearNeighbours) {
  const Two two = approaching();
  const double atSpacing = K::W(0.25, h), ratio = two.W() / atSpacing;
  const Sums<double, 2> sums = sumsOf(term::Concentration{atSpacing, 2}, two);
  const Vec<2> gradient = sums.kernelGradient.total(two.F(), two.r);
  const double expected = 3.0 / 0.9 * (1 + 0.2 * std::pow(ratio, 4)) * two.F() * two.r[0];
  EXPECT_NEAR(gradient[0], expected, 1e-14 * std::abs(expected));  // a dozen roundings
  EXPECT_DOUBLE_EQ(sums.positionDivergence, -3.0 / 0.9 * two.F() * normSquared(two.r));
}

/// Velocities of both particles after one collision.
std::pair<Vec<2>, Vec<2>> collided(const Two& ij, double restitution, double range) {
  const term::Collision collision{restitution, range};
  Two ji = ij;
  std::swap(ji.i, ji.j);
  ji.r = -ij.r;
  return {ij.i.velocity + velocityChangeOf(collision, ij),
          ij.j.velocity + velocityChangeOf(collision, ji)};
}

TEST(Terms, CollisionObeysRestitutionAndKeepsMomentum) {
  const Two ij = approaching();
  const double before = ij.velocityDotR();
  for (const double restitution : {0.0, 0.01, 1.0}) {
    const auto [vi, vj] = collided(ij, restitution, 0.5);
    // Numbers of about 1 and a few roundings of each.
    EXPECT_NEAR(dot(vi - vj, ij.r), -restitution * before, ulp);
    const Vec<2> momentum = 2.0 * vi + 3.0 * vj;
    EXPECT_NEAR(momentum[0], 2.0 * 1.0 - 3.0 * 1.0, ulp);
    EXPECT_NEAR(momentum[1], 2.0 * 0.5 + 3.0 * 0.25, ulp);
  }
}

TEST(Terms, ElasticCollisionKeepsEnergy) {
  const Two ij = approaching();
  const auto [vi, vj] = collided(ij, 1.0, 0.5);
  const auto energy = [](const Vec<2>& a, const Vec<2>& b) {
    return normSquared(a) + 1.5 * normSquared(b);
  };
  // Energies of about 3: a few roundings each.
  EXPECT_NEAR(energy(vi, vj), energy(ij.i.velocity, ij.j.velocity), 1e-14);
}

TEST(Terms, NoCollisionOfRecedingOrDistantPairs) {
  EXPECT_EQ(normSquared(velocityChangeOf(term::Collision{0.5, 0.5}, receding())), 0);
  EXPECT_EQ(normSquared(velocityChangeOf(term::Collision{0.5, 0.1}, approaching())), 0);
}

TEST(Terms, PacksOfPairsGiveWhatSinglePairsGive) {
  expectLanesAreSingles(term::DensitySum{});
  expectLanesAreSingles(term::Continuity{});
  expectLanesAreSingles(term::PressureDensitySquared{});
  expectLanesAreSingles(term::PressureDensityProduct{});
  expectLanesAreSingles(term::MonaghanViscosity{{0.8, 1.5}, 10});
  expectLanesAreSingles(term::MonaghanViscosityOfPhases{{0.8, 1.5}});
  expectLanesAreSingles(term::LaminarViscosity{0.3, 3});
  expectLanesAreSingles(term::LaminarViscosityOfPhases{});
  expectLanesAreSingles(term::DensityGradient{});
  // delta c h V F/rho is up to 8 here; it multiplies a jump of up to 4 less a slope of up to 1.
  expectLanesAreSingles(term::DensityDiffusion{0.1, 10}, 40);
  expectLanesAreSingles(term::FluidAtWall{});
  expectLanesAreSingles(term::VelocityAtWall{});
  expectLanesAreSingles(term::Concentration{1.5, 3});
  expectLanesAreSingles(term::Collision{0.5, 0.25});
}

}  // namespace
}  // namespace plenum
