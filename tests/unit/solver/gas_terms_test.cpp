// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each term of gases against the formula of its source, written out by hand for one pair of
// particles with smoothing lengths of their own.
#include "solver/gas_terms.hpp"

#include "tests/unit/solver/lanes.hpp"
#include "tests/unit/solver/two_particles.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

using namespace test;

constexpr double hi = 0.3, hj = 0.2;

/// The two as a loop for own smoothing lengths sees them.
struct GasPair : Two {
  KernelValues<double> ofI{K::W(norm(r), hi), K::F(norm(r), hi)};
  KernelValues<double> ofJ{K::W(norm(r), hj), K::F(norm(r), hj)};

  double F() const { return 0.5 * (ofI.F + ofJ.F); }
  Pair<double, 2> pair() const {
    return {i,   j,   r,  normSquared(r), velocityDotR(), 0.5 * (hi + hj), 0.5 * (ofI.W + ofJ.W),
            F(), ofI, ofJ};
  }
  GasPair swapped() const {
    GasPair other = *this;
    std::swap(other.i, other.j);
    std::swap(other.ofI, other.ofJ);
    other.r = -r;
    return other;
  }
};

GasPair gasPair() {
  GasPair two;
  two.i.soundSpeed = 4;
  two.j.soundSpeed = 16;
  two.i.internalEnergy = 2.5;
  two.j.internalEnergy = 0.75;
  two.i.viscosityLimiter = 0.2;
  two.j.viscosityLimiter = 0.6;
  return two;
}

template <class Term>
Sums<double, 2> sumsOfGas(const Term& term, const GasPair& two) {
  Sums<double, 2> sums;
  term(two.pair(), sums);
  return sums;
}

/// What i gets from a term, in whichever form it is.
struct Given {
  Vec<2> force;
  double power;
};

template <class Term>
Given givenBy(const Term& term, const GasPair& two) {
  Exchange<double, 2> exchange;
  Sums<double, 2> sums;
  if constexpr (Exchanges<Term, double, 2>)
    term(two.pair(), exchange);
  else if constexpr (ExchangesAndGives<Term, double, 2>)
    term(two.pair(), exchange, sums);
  else
    term(two.pair(), sums);
  return {exchange.force.total(two.F(), two.r), exchange.power + sums.power};
}

template <class Term>
Vec<2> forceOn(const Term& term, const GasPair& two) {
  return givenBy(term, two).force;
}

template <class Term>
double powerOf(const Term& term, const GasPair& two) {
  return givenBy(term, two).power;
}

/// A dozen roundings.
void expectClose(double value, double expected) {
  EXPECT_NEAR(value, expected, 1e-14 * std::abs(expected));
}

TEST(GasTerms, OmegaIsTheSlopeOfTheSumOverSmoothingLengths) {
  // Omega rho = rho + h/d d rho/dh of the sum m W(h), here of one neighbour, by differences.
  const GasPair two = gasPair();
  const double step = 1e-5, r = norm(two.r);
  const double slope = 3.0 * (K::W(r, hi + step) - K::W(r, hi - step)) / (2 * step);
  const double expected = 3.0 * two.ofI.W + hi / 2 * slope;
  // The difference quotient is right to step^2/h^2.
  EXPECT_NEAR(sumsOfGas(term::OmegaDensity{}, two).omegaDensity, expected, 1e-8 * expected);
}

TEST(GasTerms, DensityMomentAndRateAreOfOwnKernels) {
  const GasPair two = gasPair();
  expectClose(sumsOfGas(term::DensityMoment{}, two).densityMoment, 3.0 * 0.9 * two.ofI.W);
  const double vDotR = 2.0 * -0.2 + 0.25 * 0.1;
  expectClose(sumsOfGas(term::DensityRate{}, two).densityRate, 3.0 * vDotR * two.ofI.F);
}

TEST(GasTerms, CurlOfARotationAndOfAShear) {
  // rho curl v = sum m v_ij x grad W: of a solid rotation v = omega x r, v_ij x r_ij is -omega r^2.
  GasPair two = gasPair();
  const double omega = 0.7;
  two.i.velocity = {{-omega * two.r[1], omega * two.r[0]}};
  two.j.velocity = {};
  const double expected = -omega * normSquared(two.r) * 3.0 * two.ofI.F;
  expectClose(sumsOfGas(term::VelocityCurl{}, two).velocityCurl.rest[0], expected);
  EXPECT_GT(expected, 0);
  two.i.velocity = 0.5 * two.r;
  EXPECT_EQ(sumsOfGas(term::VelocityCurl{}, two).velocityCurl.rest[0], 0);
}

TEST(GasTerms, PressureForcesUseTheKernelsOfBoth) {
  const GasPair two = gasPair();
  const double Pi = 5.0 / (1.1 * 1.1), Pj = -2.0 / (0.9 * 0.9);
  const Vec<2> force = forceOn(term::PressureGradH{}, two);
  for (int a = 0; a < 2; ++a)
    expectClose(force[a], -2.0 * 3.0 * (Pi * two.ofI.F + Pj * two.ofJ.F) * two.r[a]);
}

/// What a pair's force takes from the motion heats the two.
template <class Force>
void expectEnergyIsKept(const Force& force, double heat) {
  const GasPair two = gasPair();
  const double motion = dot(forceOn(force, two), two.i.velocity - two.j.velocity);
  EXPECT_NE(heat, 0);
  EXPECT_NEAR(heat, -motion, 1e-13 * std::abs(heat));  // two dozen roundings of each
}

TEST(GasTerms, EachPairKeepsItsEnergy) {
  const GasPair two = gasPair(), swapped = two.swapped();
  const auto ofBoth = [&](const auto& term) { return powerOf(term, two) + powerOf(term, swapped); };
  const auto work = [](const GasPair& pair) {
    return pair.i.mass * pair.i.pressureOverDensitySquared *
           sumsOfGas(term::DensityRate{}, pair).densityRate;
  };
  expectEnergyIsKept(term::PressureGradH{}, work(two) + work(swapped));
  expectEnergyIsKept(term::PressureDensitySquared{}, ofBoth(term::PressureWork{}));
  const term::HeatingViscosity heating{{{0.8, 1.5}}};
  expectEnergyIsKept(heating, ofBoth(heating));
  const term::BalsaraViscosity limited{{{{0.8, 1.5}}}};
  expectEnergyIsKept(limited, ofBoth(limited));
}

TEST(GasTerms, ViscosityHeatsBothAlikeAndTheTensorHasItsSoftening) {
  const GasPair two = gasPair();
  const double h = 0.25, vDotR = 2.0 * -0.2 + 0.25 * 0.1;
  const double mu = h * vDotR / (0.05 + 0.1 * h * h);
  const double Pi = (-0.8 * 10 * mu + 0.5 * mu * mu) / 1.0;
  const double expected = 0.5 * 2.0 * 3.0 * Pi * two.F() * vDotR;
  const term::HeatingViscosity heating{{{0.8, 0.5, 0.1}}};
  expectClose(powerOf(heating, two), expected);
  expectClose(powerOf(heating, two.swapped()), expected);
  EXPECT_GT(expected, 0);
  expectClose(powerOf(term::BalsaraViscosity{{{{0.8, 0.5, 0.1}}}}, two), 0.4 * expected);
}

TEST(GasTerms, HeatFlowsFromHotToColdAndNoneIsLost) {
  const GasPair two = gasPair();
  const double signal = std::sqrt(7.0 / 1.0);  // of |p_i - p_j| = 7 and a mean density of 1
  const double expected = 2.0 * 3.0 / 1.0 * 0.7 * signal * (2.5 - 0.75) * norm(two.r) * two.F();
  const term::Conductivity conductivity{0.7};
  expectClose(powerOf(conductivity, two), expected);
  expectClose(powerOf(conductivity, two.swapped()), -expected);
  EXPECT_LT(expected, 0) << "the hotter one cools";
}

TEST(GasTerms, PacksOfPairsGiveWhatSinglePairsGive) {
  expectLanesAreSingles(term::OmegaDensity{});
  expectLanesAreSingles(term::DensityMoment{});
  expectLanesAreSingles(term::DensityRate{});
  expectLanesAreSingles(term::VelocityCurl{}, 1);  // differences of products of about 1
  expectLanesAreSingles(term::PressureGradH{});
  expectLanesAreSingles(term::PressureWork{});
  expectLanesAreSingles(term::HeatingViscosity{{{0.8, 1.5}}});
  expectLanesAreSingles(term::BalsaraViscosity{{{{0.8, 1.5}}}});
  expectLanesAreSingles(term::Conductivity{0.7});
}

}  // namespace
}  // namespace plenum
