// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/sedov_blast.hpp"

#include "solver/measures/gas.hpp"
#include "tests/unit/solver/measures/water.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum {
namespace {

/// Integral over lambda from 0 to 1 by Simpson's rule in mu, lambda = 1 - (1 - mu)^2: points are
/// dense at the shock, where the flow changes fastest.
template <class Function>
double integral(Function&& of) {
  const int n = 20000;
  double sum = 0;
  for (int k = 0; k <= n; ++k) {
    const double inner = 1 - static_cast<double>(k) / n;
    const double weight = k == 0 || k == n ? 1 : (k % 2 == 1 ? 4 : 2);
    sum += weight * 2 * inner * of(1 - inner * inner);
  }
  return sum / (3 * n);
}

TEST(SedovBlast, KammAndTimmesStandardCases) {
  // LA-UR-07-2849, gamma = 1.4, density 1, t = 1: energies at which the shock is at 0.5, 0.75, 1.
  // In 1-D they count one side. Those energies are 3.6e-4, 3.3e-5 and 2e-7 away from what the
  // equations give (the next test), so the radii are by a third, a quarter and a fifth of that.
  EXPECT_NEAR(SedovBlast(1, 1.4).shockRadius(1, 2 * 0.0673185, 1), 0.5, 0.7e-4);
  EXPECT_NEAR(SedovBlast(2, 1.4).shockRadius(1, 0.311357, 1), 0.75, 0.7e-5);
  EXPECT_NEAR(SedovBlast(3, 1.4).shockRadius(1, 0.851072, 1), 1, 1e-6);
}

TEST(SedovBlast, EnergiesOfAnIntegrationOverRadius) {
  // Euler's equations of f, g, q over lambda (not f/lambda, ln g, ln q over ln lambda), Runge-Kutta
  // with 200,000 equal steps, whose mass was 1 to 2e-12; digits as printed.
  EXPECT_NEAR(SedovBlast(1, 1.4).alpha(), 1.077485585, 1e-9);
  EXPECT_NEAR(SedovBlast(2, 1.4).alpha(), 0.984074017, 1e-9);
  EXPECT_NEAR(SedovBlast(3, 1.4).alpha(), 0.851071855, 1e-9);
}

TEST(SedovBlast, RadiusGrowsAsItShould) {
  const SedovBlast blast(3, 5.0 / 3);
  const double R = blast.shockRadius(2, 3, 5);
  EXPECT_NEAR(blast.shockRadius(4, 3, 5) / R, std::pow(2, 0.4), 1e-14);  // some roundings
  EXPECT_NEAR(blast.shockRadius(2, 6, 5) / R, std::pow(2, 0.2), 1e-14);
  EXPECT_NEAR(blast.shockRadius(2, 3, 10) / R, std::pow(2, -0.2), 1e-14);
}

class SedovBlasts : public testing::TestWithParam<std::pair<int, double>> {
 protected:
  int dim = GetParam().first;
  double gamma = GetParam().second;
  SedovBlast blast{dim, gamma};
};

TEST_P(SedovBlasts, BeginWithAStrongShock) {
  const GasState behind = blast.at(1), ahead = blast.at(1.0001);
  EXPECT_DOUBLE_EQ(behind.density, (gamma + 1) / (gamma - 1));
  EXPECT_DOUBLE_EQ(behind.velocity, 2 / (gamma + 1));
  EXPECT_DOUBLE_EQ(behind.pressure, 2 / (gamma + 1));
  EXPECT_EQ(ahead.density, 1);
  EXPECT_EQ(ahead.velocity, 0);
  EXPECT_EQ(ahead.pressure, 0);
}

TEST_P(SedovBlasts, HoldTheGasThatTheyMet) {
  const double mass =
      integral([&](double x) { return blast.at(x).density * std::pow(x, dim - 1); });
  // Simpson's rule and Runge-Kutta, both of fourth order, over thousands of steps; the kink at the
  // table's inner end.
  EXPECT_NEAR(mass * dim, 1, 1e-7);
}

TEST_P(SedovBlasts, HoldTheEnergyOfTheExplosion) {
  const double energy = integral([&](double x) {
    const GasState gas = blast.at(x);
    return (0.5 * gas.density * gas.velocity * gas.velocity + gas.pressure / (gamma - 1)) *
           std::pow(x, dim - 1);
  });
  const double delta = 2.0 / (dim + 2);
  EXPECT_NEAR(unitSphereSurface(dim) * delta * delta * energy / blast.alpha(), 1, 1e-7);
}

/// Energy inside a surface r/R = const does not change: what is convected through the surface as it
/// moves is the work of the pressure (Landau & Lifshitz, Fluid Mechanics, section 106).
TEST_P(SedovBlasts, PassNoEnergyInwards) {
  for (const double x : {0.99, 0.9, 0.7, 0.5, 0.3, 0.05, 0.0005}) {
    const GasState g = blast.at(x);
    const double energy = 0.5 * g.density * g.velocity * g.velocity + g.pressure / (gamma - 1);
    // Relative to what is convected. Further in than 1e-3 the mass is left out: 7e-8 at gamma = 6,
    // less elsewhere, as interpolation between the steps is.
    EXPECT_NEAR((g.velocity - x) * energy + g.velocity * g.pressure, 0, 1e-7 * x * energy) << x;
  }
}

INSTANTIATE_TEST_SUITE_P(All, SedovBlasts,
                         testing::Values(std::pair{1, 1.4}, std::pair{2, 1.4}, std::pair{3, 1.4},
                                         std::pair{1, 5.0 / 3}, std::pair{2, 5.0 / 3},
                                         std::pair{3, 5.0 / 3}, std::pair{2, 2.0},
                                         std::pair{3, 2.0}, std::pair{3, 1.1}, std::pair{3, 6.0},
                                         std::pair{1, 3.0}));

TEST(SedovBlast, VacuumInTheMiddleIsRefused) {
  const auto refusal = [](int dim, double gamma) {
    return test::refusalOf([&] { SedovBlast(dim, gamma); });
  };
  EXPECT_NE(refusal(3, 7).find("gamma = 7: must be above 1 and below 7"), std::string::npos);
  EXPECT_EQ(refusal(2, 7), "no error");
  EXPECT_NE(refusal(2, 1).find("gamma = 1: must be above 1"), std::string::npos);
}

}  // namespace
}  // namespace plenum
