// SPDX-License-Identifier: GPL-3.0-or-later
//
// Implosion and explosion: particles that carry the exact state measure no error,
// and known errors as large as they are.
#include "solver/measures/noh.hpp"
#include "solver/measures/sedov.hpp"
#include "tests/unit/solver/measures/gas.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

/// Makes the measure that `Measure` is and gives every particle `density(radius, time)` of it.
template <template <int> class Measure, int Dim, class Settings>
struct Exact {
  Exact(const Settings& settings, double gamma, double half, double spacing, double time)
      : solver(test::idealGas(gamma)),
        scene(test::gasBox<Dim>(half, spacing)),
        measure(settings, test::observedGas(scene, solver), "measures.it") {
    scene.info.time = time;
    for (std::size_t i = 0; i < scene.particles.size(); ++i)
      test::setDensity(scene.particles, i, measure.density(radius(i), time));
  }
  double radius(std::size_t i) const { return norm(scene.particles[field::position][i]); }
  double value(const std::string& name) const {
    return valueOf(test::rowOf(measure, scene, solver), name);
  }

  SolverSettings solver;
  Scene<Dim> scene;
  Measure<Dim> measure;
};

template <int Dim>
void expectNohIsExact() {
  Exact<Noh, Dim, NohSettings> noh(NohSettings{}, 5.0 / 3, 0.5, Dim == 3 ? 0.04 : 0.01, 0.6);
  // gamma = 5/3: the gas is compressed by 4^d behind a shock at t/3.
  EXPECT_NEAR(noh.measure.shockRadius(0.6), 0.2, 1e-15);
  EXPECT_NEAR(noh.measure.densityBehind(), std::pow(4, Dim), 1e-12);
  EXPECT_NEAR(noh.measure.density(0.3, 0.6), std::pow(3, Dim - 1), 1e-13);
  EXPECT_EQ(noh.value("l1_density"), 0);
  EXPECT_NEAR(noh.value("density_behind_shock"), 1, 1e-13);  // a sum of some thousand terms
  for (std::size_t i = 0; i < noh.scene.particles.size(); ++i)
    test::setDensity(noh.scene.particles, i, noh.scene.particles[field::density][i] - 0.1);
  EXPECT_NEAR(noh.value("l1_density"), 0.1 / std::pow(4, Dim), 1e-14);
  EXPECT_NEAR(noh.value("density_behind_shock"), 1 - 0.1 / std::pow(4, Dim), 1e-13);
}

TEST(Noh, TheExactStateHasNoErrorAndKnownOnesAreFound) {
  expectNohIsExact<1>();
  expectNohIsExact<2>();
  expectNohIsExact<3>();
}

TEST(Noh, MassIsKept) {
  // What is within r at time t began within r + v0 t: 2-D, uniform density 1.
  const Exact<Noh, 2, NohSettings> noh(NohSettings{}, 5.0 / 3, 0.1, 0.05, 0.6);
  const int n = 100000;
  double mass = 0;
  for (int k = 0; k < n; ++k) {
    const double r = 0.5 * (k + 0.5) / n;
    mass += noh.measure.density(r, 0.6) * 2 * r * 0.5 / n;
  }
  // The midpoint rule misses the shock by at most half a step: 0.5/n times a jump of 13 x 2 x 0.2.
  EXPECT_NEAR(mass, 1.1 * 1.1, 2e-5);
}

TEST(Noh, OnlyWhatTheEdgeHasNotReachedCounts) {
  const auto disturbedFrom = [](const NohSettings& settings, double from) {
    Exact<Noh, 2, NohSettings> noh(settings, 5.0 / 3, 0.5, 0.01, 0.6);
    for (std::size_t i = 0; i < noh.scene.particles.size(); ++i)
      if (noh.radius(i) > from) noh.scene.particles[field::density][i] = 99;
    return noh.value("l1_density");
  };
  NohSettings settings;  // counts up to twice the shock's radius, 0.4
  EXPECT_EQ(disturbedFrom(settings, 0.4), 0);
  EXPECT_GT(disturbedFrom(settings, 0.38), 0);
  settings.radius = 0.9;  // its edge is at 0.3
  EXPECT_EQ(disturbedFrom(settings, 0.3), 0);
  EXPECT_GT(disturbedFrom(settings, 0.28), 0);
  settings.within = 0.45;
  EXPECT_EQ(disturbedFrom(settings, 0.45), 0);
  EXPECT_GT(disturbedFrom(settings, 0.43), 0);
  settings = {};
  settings.radius = 0.5;  // all of it is in the shock
  EXPECT_TRUE(std::isnan(disturbedFrom(settings, 1)));
}

template <int Dim>
void expectSedovIsExact() {
  const double time = 0.3, spacing = Dim == 3 ? 0.04 : 0.01;
  SedovSettings settings;
  settings.density = 2;
  settings.energy = SedovBlast(Dim, 1.4).alpha() * 2 * std::pow(0.7, Dim + 2) / (time * time);
  Exact<Sedov, Dim, SedovSettings> sedov(settings, 1.4, 1, spacing, time);
  EXPECT_NEAR(sedov.measure.shockRadius(time), 0.7, 1e-14);
  EXPECT_EQ(sedov.value("l1_density"), 0);
  // The densest shell is the outermost that is behind the shock as a whole, or the one before.
  EXPECT_NEAR(sedov.value("shock_radius"), 0.7, 1.5 * spacing + 1e-12);
  EXPECT_LT(sedov.value("peak_density"), 1);
  EXPECT_GT(sedov.value("peak_density"),
            Dim == 3 ? 0.4 : 0.85);  // shells of 0.06 R and 0.014 R; it falls by 1/e in some 0.06 R
  for (std::size_t i = 0; i < sedov.scene.particles.size(); ++i)
    test::setDensity(sedov.scene.particles, i, sedov.scene.particles[field::density][i] + 0.1);
  EXPECT_NEAR(sedov.value("l1_density"), 0.1 / 2, 1e-14);  // roundings of densities below 12
}

TEST(Sedov, TheExactStateHasNoErrorAndKnownOnesAreFound) {
  expectSedovIsExact<1>();
  expectSedovIsExact<2>();
  expectSedovIsExact<3>();
}

TEST(Sedov, WhatIsFarOutsideDoesNotCount) {
  SedovSettings settings;
  settings.energy = SedovBlast(2, 1.4).alpha() * std::pow(0.5, 4);
  Exact<Sedov, 2, SedovSettings> sedov(settings, 1.4, 1, 0.01, 1);
  for (std::size_t i = 0; i < sedov.scene.particles.size(); ++i)
    if (sedov.radius(i) > 0.6) sedov.scene.particles[field::density][i] = 0.5;
  EXPECT_EQ(sedov.value("l1_density"), 0);
  EXPECT_NEAR(sedov.value("shock_radius"), 0.5, 0.015);
}

}  // namespace
}  // namespace plenum
