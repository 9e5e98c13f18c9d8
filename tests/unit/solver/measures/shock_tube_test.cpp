// SPDX-License-Identifier: GPL-3.0-or-later
//
// Particles that carry the exact state of a tube measure no error, and known errors as large as
// they are.
#include "solver/measures/shock_tube.hpp"

#include "particles/errors.hpp"
#include "tests/unit/solver/measures/gas.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

RiemannSettings sod() {
  RiemannSettings s;
  s.position = 0.1;
  s.left = RiemannSideSettings{1, 0, 1};
  s.right = RiemannSideSettings{0.125, 0, 0.1};
  return s;
}

RiemannSettings isothermalTube() {
  RiemannSettings s;
  s.left = RiemannSideSettings{4, 0, {}};
  s.right = RiemannSideSettings{1, 0, {}};
  return s;
}

RiemannSettings streams() {
  RiemannSettings s;
  s.left = RiemannSideSettings{1, 2, {}};
  s.right = RiemannSideSettings{1, -2, {}};
  return s;
}

/// A box of gas that carries the exact state at time t.
template <int Dim>
struct Tube {
  Tube(const RiemannSettings& tubeSettings, const SolverSettings& solverSettings, double half,
       double spacing, double time)
      : solver(solverSettings),
        scene(test::gasBox<Dim>(half, spacing)),
        measure(tubeSettings, test::observedGas(scene, solver), "measures.riemann") {
    scene.info.time = time;
    const int axis = tubeSettings.axis[0] - 'x';
    const double gamma = solver.isIdealGas() ? solver.adiabaticIndex : 1;
    for (std::size_t i = 0; i < scene.particles.size(); ++i) {
      const double x = scene.particles[field::position][i][axis] - tubeSettings.position;
      const GasState gas = measure.exact().at(time > 0 ? x / time : x * 1e300);
      test::setDensity(scene.particles, i, gas.density);
      scene.particles[field::velocity][i] = {};
      scene.particles[field::velocity][i][axis] = gas.velocity;
      scene.particles[field::pressure][i] = gas.pressure;
      if (gamma > 1)
        scene.particles[field::internalEnergy][i] = gas.pressure / ((gamma - 1) * gas.density);
    }
  }
  double value(const std::string& name) const {
    return valueOf(test::rowOf(measure, scene, solver), name);
  }

  SolverSettings solver;
  Scene<Dim> scene;
  ShockTube<Dim> measure;
};

TEST(ShockTube, TheExactStateHasNoError) {
  for (const double time : {0.0, 0.2}) {
    const Tube<1> tube(sod(), test::idealGas(1.4), 0.5, 1e-3, time);
    for (const char* name : {"l1_density", "l1_velocity", "l1_pressure"})
      EXPECT_EQ(tube.value(name), 0) << name;  // V = m/rho is a rounding off, errors are not
    EXPECT_LT(tube.value("l1_internal_energy"), 1e-15);  // one rounding more
  }
  EXPECT_EQ((Tube<1>(sod(), test::idealGas(1.4), 0.5, 1e-3, 0.2).value("velocity_noise")), 0);
  EXPECT_EQ((Tube<1>(isothermalTube(), test::isothermalGas(1), 8, 0.02, 5).value("velocity_noise")),
            0);
}

TEST(ShockTube, TransverseAxesDoNotMatter) {
  RiemannSettings along = sod();
  along.axis = "y";
  const Tube<2> tube(along, test::idealGas(1.4), 0.5, 0.02, 0.2);
  EXPECT_EQ(tube.value("l1_density"), 0);
  EXPECT_EQ(tube.value("l1_velocity"), 0);
  const Tube<1> line(sod(), test::idealGas(1.4), 0.5, 0.02, 0.2);
  EXPECT_NEAR(tube.value("shock_width"), line.value("shock_width"), 1e-12);  // sums of h
}

TEST(ShockTube, KnownErrorsAreFound) {
  Tube<1> tube(sod(), test::idealGas(1.4), 0.5, 1e-3, 0.2);
  for (std::size_t i = 0; i < tube.scene.particles.size(); ++i) {
    test::setDensity(tube.scene.particles, i, tube.scene.particles[field::density][i] + 0.01);
    tube.scene.particles[field::velocity][i][0] -= 0.02;
    tube.scene.particles[field::pressure][i] += 0.03;
    tube.scene.particles[field::internalEnergy][i] += 0.04;
  }
  // The plateau of Sod's tube to five digits: Toro, test 1. e* = p*/(0.4 rho*) = 2.8535.
  EXPECT_NEAR(tube.value("l1_density"), 0.01 / 0.26557, 1e-6);
  EXPECT_NEAR(tube.value("l1_velocity"), 0.02, 1e-15);
  EXPECT_NEAR(tube.value("l1_pressure"), 0.03 / 0.30313, 2e-6);
  EXPECT_NEAR(tube.value("l1_internal_energy"), 0.04 / 2.8535, 1e-6);
  EXPECT_NEAR(tube.value("velocity_noise"), 0.02, 1e-15);
}

TEST(ShockTube, OnlyTheWindowCounts) {
  RiemannSettings settings = sod();
  settings.window = {-0.2, 0.3};
  Tube<1> tube(settings, test::idealGas(1.4), 0.5, 1e-3, 0.1);
  for (std::size_t i = 0; i < tube.scene.particles.size(); ++i)
    if (tube.scene.particles[field::position][i][0] > 0.3)
      tube.scene.particles[field::velocity][i][0] = 7;
  EXPECT_EQ(tube.value("l1_velocity"), 0);
  settings.window.clear();
  // The disturbed fifth of the gas was at rest.
  const auto row =
      test::rowOf(ShockTube<1>(settings, test::observedGas(tube.scene, tube.solver), "k"),
                  tube.scene, tube.solver);
  EXPECT_NEAR(valueOf(row, "l1_velocity"), 0.2 * 7, 1e-9);  // sums of V = m/rho over 1000 particles
}

TEST(ShockTube, NoiseIsOfTheGasBetweenContactAndShock) {
  // At t = 0.2 contact and shock of Sod's tube are at 0.1 + 0.1855 and 0.1 + 0.3504; h = 0.0015, so
  // what counts is [0.3005, 0.4354].
  const auto disturbed = [](double lower, double upper) {
    Tube<1> tube(sod(), test::idealGas(1.4), 0.5, 1e-3, 0.2);
    for (std::size_t i = 0; i < tube.scene.particles.size(); ++i) {
      const double x = tube.scene.particles[field::position][i][0];
      if (x > lower && x < upper) tube.scene.particles[field::velocity][i][0] += 1;
    }
    return tube.value("velocity_noise");
  };
  EXPECT_EQ(disturbed(-0.5, 0.3), 0);
  EXPECT_EQ(disturbed(0.436, 0.5), 0);
  EXPECT_NEAR(disturbed(0.3, 0.436), 1, 1e-14);  // roundings of 1
  // In a tube of isothermal gas it begins at the tail of the fan, at -0.3 t: [-1.2, 6.7] with
  // h = 0.03 at t = 5. In streams of it the contact counts as an end, too.
  Tube<1> tube(isothermalTube(), test::isothermalGas(1), 8, 0.02, 5);
  for (std::size_t i = 0; i < tube.scene.particles.size(); ++i)
    if (std::abs(tube.scene.particles[field::position][i][0]) < 0.1)
      tube.scene.particles[field::velocity][i][0] += 1;
  EXPECT_GT(tube.value("velocity_noise"), 0.1);
  Tube<1> two(streams(), test::isothermalGas(1), 8, 0.02, 5);
  for (std::size_t i = 0; i < two.scene.particles.size(); ++i)
    if (std::abs(two.scene.particles[field::position][i][0]) < 0.1)
      two.scene.particles[field::velocity][i][0] += 1;
  EXPECT_LT(two.value("velocity_noise"), 1e-15);  // v* = 0 to a rounding
}

TEST(ShockTube, NoiseMarginIsInEachParticlesSmoothingLengths) {
  Tube<1> tube(isothermalTube(), test::isothermalGas(1), 8, 0.02, 5);
  tube.scene.particles.add({field::smoothingLength});
  for (double& h : tube.scene.particles[field::smoothingLength]) h = 0.5;
  // 10 h is 5 m: more than half of the plateau of 8.5 m, so nobody is inside.
  EXPECT_TRUE(std::isnan(tube.value("velocity_noise")));
  for (double& h : tube.scene.particles[field::smoothingLength]) h = 0.4;
  EXPECT_EQ(tube.value("velocity_noise"), 0);
}

TEST(ShockTube, WidthOfARampIsFourFifths) {
  for (const bool onLeft : {false, true}) {
    RiemannSettings settings = sod();
    settings.position = 0;
    if (onLeft) std::swap(settings.left, settings.right);
    Tube<1> tube(settings, test::idealGas(1.4), 0.5, 1e-3, 0.2);
    const auto& wave = onLeft ? tube.measure.exact().left() : tube.measure.exact().right();
    ASSERT_TRUE(wave.isShock);
    const double ramp = 0.06;
    for (std::size_t i = 0; i < tube.scene.particles.size(); ++i) {
      const double x = tube.scene.particles[field::position][i][0];
      const double behind = (onLeft ? 1 : -1) * (x - wave.head * 0.2) / ramp + 0.5;
      if (behind > -3 && behind < 1)
        test::setDensity(tube.scene.particles, i,
                         0.125 + (wave.behind.density - 0.125) * std::max(0.0, behind));
    }
    // h = 0.0015; each end is the first particle beyond it, up to a spacing away.
    EXPECT_NEAR(tube.value("shock_width"), 0.8 * ramp / 0.0015, 2 * 1e-3 / 0.0015);
    EXPECT_GE(tube.value("shock_width"), 0.8 * ramp / 0.0015);
  }
}

TEST(ShockTube, WithoutAShockThereIsNoWidth) {
  RiemannSettings settings = sod();
  settings.left = RiemannSideSettings{1, -0.5, 1};
  settings.right = RiemannSideSettings{1, 0.5, 1};
  const Tube<1> tube(settings, test::idealGas(1.4), 0.5, 1e-3, 0.1);
  EXPECT_TRUE(std::isnan(tube.value("shock_width")));
  EXPECT_EQ(tube.value("l1_density"), 0);
  EXPECT_TRUE(std::isnan((Tube<1>(sod(), test::idealGas(1.4), 0.5, 1e-3, 0).value("shock_width"))));
}

TEST(ShockTube, OtherGasesAndStatesAreRefused) {
  const Scene<1> scene = test::gasBox<1>(1, 0.1);
  const auto refusal = [&](const RiemannSettings& settings, const SolverSettings& solver) {
    return test::refusalOf(
        [&] { ShockTube<1>(settings, test::observedGas(scene, solver), "measures.riemann"); });
  };
  const auto expectPart = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  expectPart(refusal(sod(), {}),
             "measures.riemann: is a flow of gases, but solver.equation_of_state = \"tait\"");
  expectPart(refusal(isothermalTube(), test::idealGas(1.4)),
             "measures.riemann.left.pressure: is missing");
  expectPart(refusal(sod(), test::isothermalGas(1)), "measures.riemann.left.pressure = 1: an iso");
  RiemannSettings parting = sod();
  parting.right->velocity = 50;
  expectPart(refusal(parting, test::idealGas(1.4)), "measures.riemann: the two sides part at 50");
}

}  // namespace
}  // namespace plenum
