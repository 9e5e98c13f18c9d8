// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each term against the formula of its source, written out by hand for one pair.
#include "solver/terms.hpp"

#include "particles/kernels.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

using K = Kernel<2, kernel::CubicSpline>;
constexpr double h = 0.3;
constexpr double ulp = 1e-15;  // relative: a few roundings

Pair<double, 2> approachingPair() {
  Pair<double, 2> ij;
  ij.i = {2.0, 1.1, 5.0, {{1.0, 0.5}}};
  ij.j = {3.0, 0.9, -2.0, {{-1.0, 0.25}}};
  ij.r = {{-0.2, 0.1}};
  ij.distanceSquared = 0.05;
  ij.h = h;
  ij.W = K::W(std::sqrt(0.05), h);
  ij.F = K::F(std::sqrt(0.05), h);
  return ij;
}

Pair<double, 2> recedingPair() {
  Pair<double, 2> ij = approachingPair();
  std::swap(ij.i.velocity, ij.j.velocity);
  return ij;
}

template <class Term>
Sums<double, 2> sumsOf(const Term& term, const Pair<double, 2>& ij) {
  Sums<double, 2> sums;
  term(ij, sums);
  return sums;
}

TEST(Terms, DensitySum) {
  const auto ij = approachingPair();
  EXPECT_DOUBLE_EQ(sumsOf(term::DensitySum{}, ij).density, 3.0 * ij.W);
  Sums<double, 2> self;
  term::DensitySum{}.self(ij.i, 7.0, self);
  EXPECT_DOUBLE_EQ(self.density, 2.0 * 7.0);
}

TEST(Terms, ContinuityRaisesTheDensityOfApproachingParticles) {
  const auto ij = approachingPair();
  const double vDotR = 2.0 * -0.2 + 0.25 * 0.1;
  const double rate = sumsOf(term::Continuity{}, ij).densityRate;
  EXPECT_NEAR(rate, 1.1 * (3.0 / 0.9) * vDotR * ij.F, ulp * std::abs(rate) * 4);
  EXPECT_GT(rate, 0);
}

TEST(Terms, PressureForms) {
  const auto ij = approachingPair();
  const auto squared = sumsOf(term::PressureDensitySquared{}, ij).acceleration;
  const auto product = sumsOf(term::PressureDensityProduct{}, ij).acceleration;
  for (int a = 0; a < 2; ++a) {
    EXPECT_DOUBLE_EQ(squared[a], -3.0 * (5.0 / (1.1 * 1.1) - 2.0 / (0.9 * 0.9)) * ij.F * ij.r[a]);
    EXPECT_DOUBLE_EQ(product[a], -3.0 * (5.0 - 2.0) / (1.1 * 0.9) * ij.F * ij.r[a]);
  }
}

TEST(Terms, MonaghanViscosityActsOnApproachingPairsOnly) {
  const auto ij = approachingPair();
  const term::MonaghanViscosity viscosity{0.8, 1.5, 10};
  const double mu = h * (2.0 * -0.2 + 0.25 * 0.1) / (0.05 + 0.01 * h * h);
  const double Pi = (-0.8 * 10 * mu + 1.5 * mu * mu) / 1.0;
  const auto acceleration = sumsOf(viscosity, ij).acceleration;
  for (int a = 0; a < 2; ++a)
    EXPECT_NEAR(acceleration[a], -3.0 * Pi * ij.F * ij.r[a], 1e-14 * std::abs(acceleration[a]));
  EXPECT_LT(dot(acceleration, ij.i.velocity - ij.j.velocity), 0) << "viscosity must brake";
  EXPECT_EQ(normSquared(sumsOf(viscosity, recedingPair()).acceleration), 0);
}

/// Velocities of both particles after one collision.
std::pair<Vec<2>, Vec<2>> collided(const Pair<double, 2>& ij, double restitution, double range) {
  const term::Collision collision{restitution, range};
  Pair<double, 2> ji = ij;
  std::swap(ji.i, ji.j);
  ji.r = -ij.r;
  return {ij.i.velocity + sumsOf(collision, ij).velocityChange,
          ij.j.velocity + sumsOf(collision, ji).velocityChange};
}

TEST(Terms, CollisionObeysRestitutionAndKeepsMomentum) {
  const auto ij = approachingPair();
  const double before = ij.velocityDotR();
  for (const double restitution : {0.0, 0.01, 1.0}) {
    const auto [vi, vj] = collided(ij, restitution, 0.5);
    EXPECT_NEAR(dot(vi - vj, ij.r), -restitution * before, 1e-15);
    const Vec<2> momentum = 2.0 * vi + 3.0 * vj;
    EXPECT_NEAR(momentum[0], 2.0 * 1.0 - 3.0 * 1.0, 1e-15);
    EXPECT_NEAR(momentum[1], 2.0 * 0.5 + 3.0 * 0.25, 1e-15);
  }
}

TEST(Terms, ElasticCollisionKeepsEnergy) {
  const auto ij = approachingPair();
  const auto [vi, vj] = collided(ij, 1.0, 0.5);
  const auto energy = [](const Vec<2>& a, const Vec<2>& b) {
    return normSquared(a) + 1.5 * normSquared(b);
  };
  EXPECT_NEAR(energy(vi, vj), energy(ij.i.velocity, ij.j.velocity), 1e-14);
}

TEST(Terms, NoCollisionOfRecedingOrDistantPairs) {
  EXPECT_EQ(normSquared(sumsOf(term::Collision{0.5, 0.5}, recedingPair()).velocityChange), 0);
  EXPECT_EQ(normSquared(sumsOf(term::Collision{0.5, 0.1}, approachingPair()).velocityChange), 0);
}

}  // namespace
}  // namespace plenum
