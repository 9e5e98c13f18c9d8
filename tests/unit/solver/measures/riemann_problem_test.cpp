// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/riemann_problem.hpp"

#include "tests/unit/solver/measures/water.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plenum {
namespace {

struct Published {
  GasState left, right;
  double pressure, velocity, densityLeft, densityRight;  // between the waves
};

// Toro, 3rd ed. 2009, tables 4.1 to 4.3, gamma = 1.4: digits as printed.
const std::vector<Published> toro{
    {{1, 0, 1}, {0.125, 0, 0.1}, 0.30313, 0.92745, 0.42632, 0.26557},
    {{1, -2, 0.4}, {1, 2, 0.4}, 0.00189, 0, 0.02185, 0.02185},
    {{1, 0, 1000}, {1, 0, 0.01}, 460.894, 19.5975, 0.57506, 5.99924},
    {{1, 0, 0.01}, {1, 0, 100}, 46.0950, -6.19633, 5.99242, 0.57511},
    {{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}, 1691.64, 8.68975, 14.2823, 31.0426},
};

/// Half of the last of `digits` printed significant digits.
double halfDigit(double value, int digits) {
  return value == 0 ? 1e-12
                    : 0.51 * std::pow(10, std::floor(std::log10(std::abs(value))) - digits + 1);
}

TEST(RiemannProblem, TorosFiveTests) {
  for (const Published& p : toro) {
    const RiemannProblem solution(p.left, p.right, 1.4);
    // Test 2 prints five decimals of p* and rho*: three and four digits.
    const bool isThin = p.pressure < 0.01;
    EXPECT_NEAR(solution.starPressure(), p.pressure, halfDigit(p.pressure, isThin ? 3 : 5));
    EXPECT_NEAR(solution.starVelocity(), p.velocity, halfDigit(p.velocity, 5));
    EXPECT_NEAR(solution.left().behind.density, p.densityLeft,
                halfDigit(p.densityLeft, isThin ? 4 : 5));
    EXPECT_NEAR(solution.right().behind.density, p.densityRight,
                halfDigit(p.densityRight, isThin ? 4 : 5));
  }
}

GasState isothermal(double density, double velocity) { return {density, velocity, density}; }

TEST(RiemannProblem, IsothermalTubes) {
  const RiemannProblem tube(isothermal(4, 0), isothermal(1, 0), 1);
  // Published to four decimals.
  EXPECT_NEAR(tube.right().behind.density, 1.9865, 0.5e-4);
  EXPECT_NEAR(tube.starVelocity(), 0.6999, 0.5e-4);
  EXPECT_NEAR(tube.right().head, 1.4094, 0.5e-4);
  EXPECT_FALSE(tube.left().isShock);
  for (const double ratio : {4.0, 16.0}) {
    const RiemannProblem t(isothermal(ratio, 0), isothermal(1, 0), 1);
    const double rho = t.left().behind.density;
    EXPECT_NEAR(t.right().behind.density, rho, 1e-14 * rho);  // no jump at the contact
    // v* from the fan, c ln(rho_L/rho*), and from the shock, c (rho* - 1)/sqrt(rho*): some
    // roundings.
    EXPECT_NEAR(t.starVelocity(), std::log(ratio / rho), 1e-14);
    EXPECT_NEAR(t.starVelocity(), (rho - 1) / std::sqrt(rho), 1e-14);
    EXPECT_NEAR(t.right().head, std::sqrt(rho), 1e-14);
    EXPECT_NEAR(t.left().tail, t.starVelocity() - 1, 1e-14);
  }
}

TEST(RiemannProblem, IsothermalStreams) {
  const double M = 2;
  const RiemannProblem streams(isothermal(1, M), isothermal(1, -M), 1);
  const double rho = 1 + M * M / 2 + M * std::sqrt(1 + M * M / 4);
  EXPECT_NEAR(streams.left().behind.density, rho, 1e-14 * rho);  // some roundings
  EXPECT_NEAR(streams.starVelocity(), 0, 1e-15);
  EXPECT_NEAR(streams.right().head, M / (rho - 1), 1e-15);  // what runs in fills the middle
  EXPECT_TRUE(streams.left().isShock && streams.right().isShock);
}

/// Differences of the fluxes of mass, momentum and energy through a front at `speed`, over the
/// largest of their parts.
std::array<double, 3> fluxJumps(const GasState& a, const GasState& b, double speed, double gamma) {
  const auto fluxes = [&](const GasState& g) {
    const double w = g.velocity - speed;
    return std::array{g.density * w, g.density * w * w + g.pressure,
                      w * (0.5 * g.density * w * w + gamma / (gamma - 1) * g.pressure)};
  };
  std::array<double, 3> jumps{};
  const auto fa = fluxes(a), fb = fluxes(b);
  for (std::size_t k = 0; k < 3; ++k)
    jumps[k] = std::abs(fa[k] - fb[k]) / (std::abs(fa[k]) + 1e-300);
  return jumps;
}

TEST(RiemannProblem, ShocksKeepMassMomentumAndEnergy) {
  int nShocks = 0;
  for (const Published& p : toro)
    for (const bool onLeft : {true, false}) {
      const RiemannProblem solution(p.left, p.right, 1.4);
      const auto& wave = onLeft ? solution.left() : solution.right();
      if (!wave.isShock) continue;
      ++nShocks;
      // p* is exact to its last bits; a strong shock multiplies them by p*/p = 5e4.
      for (const double jump : fluxJumps(onLeft ? p.left : p.right, wave.behind, wave.head, 1.4))
        EXPECT_LT(jump, 1e-11);
    }
  EXPECT_EQ(nShocks, 5);
}

TEST(RiemannProblem, FansJoinAndKeepTheirInvariants) {
  for (const double gamma : {1.0, 1.0001, 1.4, 5.0 / 3}) {
    const GasState left{3, 0.2, 3};
    const RiemannProblem solution(left, {1, 0.2, 0.4}, gamma);
    const auto& fan = solution.left();
    ASSERT_FALSE(fan.isShock);
    const auto near = [](const GasState& a, const GasState& b) {
      // Steps of 1e-9 in x/t change the state by as much; 1e-4 next to gamma = 1 loses digits.
      EXPECT_NEAR(a.density, b.density, 1e-8);
      EXPECT_NEAR(a.velocity, b.velocity, 1e-8);
      EXPECT_NEAR(a.pressure, b.pressure, 1e-8);
    };
    near(solution.at(fan.head + 1e-9), left);
    near(solution.at(fan.tail - 1e-9), fan.behind);
    for (const double share : {0.1, 0.5, 0.9}) {
      const double speed = fan.head + share * (fan.tail - fan.head);
      const GasState gas = solution.at(speed);
      const double a = std::sqrt(gamma * gas.pressure / gas.density);
      EXPECT_NEAR(gas.velocity - a, speed, 1e-12);  // a characteristic; some roundings of 1
      EXPECT_NEAR(gas.pressure / std::pow(gas.density, gamma), 3 / std::pow(3, gamma), 1e-11);
    }
  }
}

TEST(RiemannProblem, SidesMayBeExchanged) {
  for (const double gamma : {1.0, 1.4})
    for (Published p : toro) {
      if (gamma == 1) {
        p.left.pressure = p.left.density;
        p.right.pressure = p.right.density;
      }
      const auto mirror = [](const GasState& g) {
        return GasState{g.density, -g.velocity, g.pressure};
      };
      const RiemannProblem a(p.left, p.right, gamma), b(mirror(p.right), mirror(p.left), gamma);
      for (double speed = -40.03; speed < 40; speed += 0.1) {
        const GasState x = a.at(speed), y = mirror(b.at(-speed));
        // p* is found by the same bisection: bits of sums taken in another order.
        EXPECT_NEAR(x.density, y.density, 1e-12 * x.density);
        EXPECT_NEAR(x.velocity, y.velocity, 1e-12 * (1 + std::abs(x.velocity)));
        EXPECT_NEAR(x.pressure, y.pressure, 1e-12 * x.pressure);
      }
    }
}

TEST(RiemannProblem, AtTheStartThereAreTwoSides) {
  const RiemannProblem tube({1, 0, 1}, {0.125, 0, 0.1}, 1.4);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(tube.at(-infinity).density, 1);
  EXPECT_EQ(tube.at(infinity).density, 0.125);
  const RiemannProblem uniform({1, 2, 3}, {1, 2, 3}, 1.4);
  for (const double speed : {-9.0, 1.9, 2.1, 9.0}) {
    EXPECT_NEAR(uniform.at(speed).density, 1, 1e-15);  // no wave changes anything
    EXPECT_NEAR(uniform.at(speed).velocity, 2, 1e-15);
  }
}

TEST(RiemannProblem, VacuumIsRefused) {
  const auto refusal = [](const GasState& left, const GasState& right, double gamma) {
    return test::refusalOf([&] { RiemannProblem(left, right, gamma); });
  };
  // 2 (a_L + a_R)/(gamma - 1) = 10 sqrt(1.4) = 11.83 m/s of parting.
  EXPECT_EQ(refusal({1, -5.9, 1}, {1, 5.9, 1}, 1.4), "no error");
  EXPECT_NE(refusal({1, -5.95, 1}, {1, 5.95, 1}, 1.4).find("part at 11.9 m/s: from 11.8322"),
            std::string::npos);
  EXPECT_EQ(refusal({1, -20, 1}, {1, 20, 1}, 1), "no error");  // thin, but never vacuum
  EXPECT_NE(refusal({0, 0, 1}, {1, 0, 1}, 1.4).find("the gas on the left has density 0"),
            std::string::npos);
  EXPECT_NE(refusal({1, 0, 1}, {1, 0, 0}, 1.4).find("on the right"), std::string::npos);
  EXPECT_NE(refusal({1, 0, 1}, {1, 0, 1}, 0.9).find("gamma = 0.9"), std::string::npos);
}

}  // namespace
}  // namespace plenum
