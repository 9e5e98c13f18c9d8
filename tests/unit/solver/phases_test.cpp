// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/phases.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

SolverSettings settings() {
  SolverSettings s;
  s.soundSpeed = 20;
  s.taitExponent = 7;
  s.backgroundPressure = 3;
  return s;
}

TEST(Phases, MaterialsOverruleTheSolver) {
  const Phases phases({{"water", 1000}, {"air", 1, 340, 1.4, -2.0}}, settings());
  ASSERT_EQ(phases.size(), 2u);
  EXPECT_EQ(phases[0].state.soundSpeed, 20);
  EXPECT_EQ(phases[0].state.exponent, 7);
  EXPECT_EQ(phases[0].state.backgroundPressure, 3);
  EXPECT_EQ(phases[1].state.soundSpeed, 340);
  EXPECT_EQ(phases[1].state.exponent, 1.4);
  EXPECT_EQ(phases[1].state.backgroundPressure, -2);
  EXPECT_EQ(phases.largestSoundSpeed(), 340);
  EXPECT_TRUE(phases.differInSoundSpeed());
  EXPECT_FALSE(phases.differInViscosity());
}

TEST(Phases, CavitateAsTheySay) {
  SolverSettings s = settings();
  const std::vector<Material> materials{{"water", 1000, {}, {}, {}, {}, 1.0}, {"oil", 900, 20.0}};
  EXPECT_EQ(Phases(materials, s)[0].state.pressure(900), 1);
  EXPECT_LT(Phases(materials, s)[1].state.pressure(800), -1000);
  s.cavitationPressure = -5;
  EXPECT_EQ(Phases(materials, s)[0].state.pressure(900), 1);
  EXPECT_EQ(Phases(materials, s)[1].state.pressure(800), -5);
}

TEST(Phases, ViscosityOnlyWhereItIsModelled) {
  SolverSettings s = settings();
  const std::vector<Material> materials{{"oil", 900, {}, {}, {}, 0.09}, {"water", 1000}};
  EXPECT_EQ(Phases(materials, s).largestKinematicViscosity(), 0);
  s.viscosity = ViscositySettings{{}, LaminarSettings{1e-3}};
  const Phases phases(materials, s);
  EXPECT_DOUBLE_EQ(phases.largestKinematicViscosity(), 1e-4);
  EXPECT_DOUBLE_EQ(phases[1].kinematicViscosity(), 1e-6);
  EXPECT_TRUE(phases.differInViscosity());
}

TEST(Phases, AWallIsLikeTheFluidOfItsDensity) {
  const Phases phases({{"water", 1000}, {"air", 1, 340}}, settings());
  const MaterialTable walls =
      phases.statesOf({{"a", "", 0, 0, 1, {}}, {"b", "", 0, 0, 8, {}}}, settings());
  const std::vector<std::int32_t> rows{0, 1};
  EXPECT_EQ(walls.of(rows, 0).soundSpeed, 340);
  EXPECT_EQ(walls.of(rows, 1).soundSpeed, 20);
  EXPECT_EQ(walls.of(rows, 1).referenceDensity, 8);
}

TEST(Tait, DensityIsTheInverseOfPressure) {
  for (const double gamma : {1.0, 1.4, 7.0}) {
    const Tait state{1000, 20, 5e3, gamma};
    for (const double density : {900.0, 1000.0, 1200.0})
      EXPECT_NEAR(state.density(state.pressure(density)), density, 1e-9);  // c^2 takes three digits
  }
}

}  // namespace
}  // namespace plenum
