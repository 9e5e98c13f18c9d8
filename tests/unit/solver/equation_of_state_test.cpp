// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/equation_of_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum {
namespace {

constexpr Tait water{1000, 30, 0, 1};
constexpr Tait stiffWater{1000, 30, 5e3, 7};

TEST(Tait, GivesTheBackgroundPressureAtTheReferenceDensity) {
  EXPECT_EQ(water.pressure(1000), 0);
  EXPECT_EQ(stiffWater.pressure(1000), 5e3);
}

TEST(Tait, HasTheSoundSpeedAtTheReferenceDensity) {
  for (const Tait& eos : {water, stiffWater}) {
    const double d = 1e-3;  // central difference: relative error (gamma d/rho)^2, below 1e-9
    const double slope = (eos.pressure(1000 + d) - eos.pressure(1000 - d)) / (2 * d);
    EXPECT_NEAR(slope, 30.0 * 30.0, 1e-4);
  }
}

TEST(Tait, CompressionEnergyIsTheIntegralOfPressureOverDensitySquared) {
  for (const Tait& eos : {water, stiffWater, Tait{1, 10, 100, 1}}) {
    const double rho0 = eos.referenceDensity, rho1 = 1.2 * rho0;
    double integral = 0;
    const int n = 2000;  // midpoint rule: relative error about 1e-7
    for (int k = 0; k < n; ++k) {
      const double rho = rho0 + (rho1 - rho0) * (k + 0.5) / n;
      integral += eos.pressure(rho) / (rho * rho) * (rho1 - rho0) / n;
    }
    EXPECT_NEAR(eos.compressionEnergy(rho1), integral, 1e-6 * integral);
    EXPECT_NEAR(eos.compressionEnergy(rho0), 0, 1e-12);
  }
}

TEST(Tait, PressureStopsAtCavitation) {
  for (Tait eos : {water, stiffWater}) {
    const Tait elastic = eos;
    eos.cavitationPressure = -2e3;
    EXPECT_EQ(eos.pressure(900), -2e3);
    EXPECT_EQ(eos.pressure(1000), elastic.pressure(1000));
    EXPECT_EQ(eos.pressure(1100), elastic.pressure(1100));
    double integral = 0;
    const int n = 20000;  // midpoint rule with a kink: relative error about 1e-8
    for (int k = 0; k < n; ++k) {
      const double rho = 1000 - 100 * (k + 0.5) / n;
      integral -= eos.pressure(rho) / (rho * rho) * 100 / n;
    }
    EXPECT_NEAR(eos.compressionEnergy(900), integral, 1e-6 * std::abs(integral));
  }
}

TEST(MaterialTable, UsesTheRowOfEachParticle) {
  const MaterialTable table({water, Tait{1, 30, 0, 1}});
  const std::vector<double> densities{1001, 2};
  const std::vector<std::int32_t> materials{0, 1};
  std::vector<double> pressures(2);
  table.pressures(densities, materials, pressures);
  EXPECT_DOUBLE_EQ(pressures[0], water.pressure(1001));
  EXPECT_DOUBLE_EQ(pressures[1], 900);
}

}  // namespace
}  // namespace plenum
