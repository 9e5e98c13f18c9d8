// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vortex and cloud: particles that carry the exact state measure no error, and known errors as
// large as they are; and what all measures of gases refuse.
#include "solver/measures/cloud.hpp"
#include "solver/measures/gresho.hpp"
#include "solver/measures/observers.hpp"
#include "tests/support/threads.hpp"
#include "tests/unit/solver/measures/gas.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace plenum {
namespace {

/// A vortex that drifts through a periodic box.
template <int Dim>
struct Vortex {
  explicit Vortex(double time) {
    settings.drift = {1.5, -0.5};
    scene.info.time = time;
    scene.info.domain.periodic.fill(true);
    for (std::size_t i = 0; i < scene.particles.size(); ++i) {
      Vec<Dim> x = scene.particles[field::position][i];
      const double r = std::hypot(x[0], x[1]), omega = measure().speed(r) / r;
      Vec<Dim> v{};
      v[0] = 1.5 - omega * x[1];
      v[1] = -0.5 + omega * x[0];
      scene.particles[field::velocity][i] = v;
      x[0] += 1.5 * time;
      x[1] -= 0.5 * time;
      scene.particles[field::position][i] = scene.info.domain.wrap(x);
    }
  }
  Gresho<Dim> measure() const { return {settings, test::observedGas(scene, solver), "k"}; }
  double value(const std::string& name) const {
    return valueOf(test::rowOf(measure(), scene, solver), name);
  }

  SolverSettings solver = test::idealGas(5.0 / 3);
  GreshoSettings settings;
  Scene<Dim> scene = test::gasBox<Dim>(0.5, Dim == 3 ? 0.05 : 0.02);
};

TEST(Gresho, TheExactVortexHasNoErrorWhereverItDrifts) {
  for (const double time : {0.0, 0.9}) {
    // Speeds near 1 and places near 1 have roundings of 1e-16; rings average them.
    EXPECT_LT(Vortex<2>(time).value("l1_velocity"), 1e-14);
    EXPECT_LT(Vortex<2>(time).value("l1_velocity_profile"), 1e-14);
    EXPECT_LT(Vortex<3>(time).value("l1_velocity"), 1e-14);
  }
}

TEST(Gresho, KnownErrorsAreFound) {
  Vortex<2> vortex(0);
  for (std::size_t i = 0; i < vortex.scene.particles.size(); ++i) {
    const Vec<2> x = vortex.scene.particles[field::position][i];
    const double error = i % 2 == 0 ? 0.3 : -0.3;
    vortex.scene.particles[field::velocity][i] +=
        error / norm(x) * Vec<2>{{-x[1], x[0]}} + 0.2 / norm(x) * x;
  }
  EXPECT_NEAR(vortex.value("l1_velocity"), 0.3, 1e-14);  // speeds towards the axis do not count
  // Errors of both signs cancel in rings, all but what is odd in their numbers.
  EXPECT_LT(vortex.value("l1_velocity_profile"), 0.1);
}

TEST(Gresho, PressureBalancesRotation) {
  const Gresho<2> exact = Vortex<2>(0).measure();
  // Published for U = 1, a = 0.2, rho = 1: p(0.2) - p(0) = 0.5 and p(0.4) - p(0) = 4 ln 2 - 2.
  EXPECT_NEAR(exact.pressureOverDensity(0.2), 0.5, 1e-15);
  EXPECT_NEAR(exact.pressureOverDensity(0.4), 4 * std::numbers::ln2 - 2, 1e-15);
  EXPECT_EQ(exact.pressureOverDensity(0.7), exact.pressureOverDensity(0.4));
  for (const double r : {0.05, 0.15, 0.25, 0.35}) {
    const double s = 1e-5;  // differences over 2 s leave s^2 of the third derivative, below 1e3
    const double slope =
        (exact.pressureOverDensity(r + s) - exact.pressureOverDensity(r - s)) / (2 * s);
    EXPECT_NEAR(slope, exact.speed(r) * exact.speed(r) / r, 1e-6);
  }
}

TEST(Cloud, CountsWhatIsDenseAndCold) {
  const SolverSettings solver = test::idealGas(5.0 / 3);
  Scene<3> scene = test::gasBox<3>(0.5, 0.05);
  const CloudSettings settings{10, 0.2, 1, 3, 2.5};
  const Cloud<3> cloud(settings, test::observedGas(scene, solver), "k");
  EXPECT_DOUBLE_EQ(cloud.mass(), 10 * 4 * std::numbers::pi / 3 * 0.008);
  EXPECT_DOUBLE_EQ(cloud.kelvinHelmholtzTime(), 1.6 * 2 * 0.2 * std::sqrt(10.0) / 2.5);
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    // 8000 particles in four kinds: cloud, cloud heated too far, cloud thinned too far, wind.
    const std::array<double, 4> density{6.5, 10, 6.3, 1}, energy{2.6, 2.8, 0.3, 3};
    test::setDensity(scene.particles, i, density[i % 4]);
    scene.particles[field::internalEnergy][i] = energy[i % 4];
  }
  scene.info.time = 0.5 * cloud.kelvinHelmholtzTime();
  const auto row = test::rowOf(cloud, scene, solver);
  // A quarter of the unit cube at 6.5; sums of 8000 terms.
  EXPECT_NEAR(valueOf(row, "cloud_mass"), 6.5 / 4 / cloud.mass(), 1e-10);
  EXPECT_DOUBLE_EQ(valueOf(row, "time_over_tau_kh"), 0.5);
}

TEST(GasMeasures, AreRefusedOfOtherFluids) {
  const Scene<2> scene = test::gasBox<2>(0.5, 0.1);
  const auto refusal = [&](const std::string& text, const SolverSettings& solver) {
    const MeasureSettings settings =
        measureSection().read(CaseNode::parse("order = false\n" + text, "case.toml"), 2);
    return test::refusalOf([&] { Observers<2>(settings, test::observedGas(scene, solver)); });
  };
  const std::vector<std::pair<std::string, std::string>> measures{
      {"noh", "{}"},
      {"sedov", "{ energy = 1, density = 1 }"},
      {"gresho", "{}"},
      {"cloud",
       "{ density = 10, radius = 1, wind_density = 1, wind_internal_energy = 1, wind_speed = 1 }"}};
  for (const auto& [name, table] : measures) {
    const std::string text = name + " = " + table;
    EXPECT_EQ(refusal(text, test::idealGas(1.4)), "no error");
    for (const auto& [solver, eos] :
         {std::pair{SolverSettings{}, "tait"}, std::pair{test::isothermalGas(1), "isothermal"}}) {
      const std::string message = refusal(text, solver);
      EXPECT_NE(message.find("measures." + name +
                             ": is a flow of an ideal gas, but "
                             "solver.equation_of_state = \"" +
                             eos),
                std::string::npos)
          << message;
    }
  }
}

TEST(GasMeasures, AddTheirColumns) {
  const Scene<2> scene = test::gasBox<2>(0.5, 0.1);
  const SolverSettings solver = test::idealGas(1.4);
  const auto names = [&](const std::string& text) {
    const auto state = test::observedGas(scene, solver);
    const auto settings =
        measureSection().read(CaseNode::parse("order = false\n" + text, "case.toml"), 2);
    std::vector<Figure> row;
    Observers<2>(settings, state).addTo(row, state);
    std::string all;
    for (const Figure& f : row) all += f.name + " ";
    return all;
  };
  EXPECT_EQ(names("riemann = { left = { density = 1, pressure = 1 }, right = { density = 0.125, "
                  "pressure = 0.1 } }\ncloud = { density = 10, radius = 1, wind_density = 1, "
                  "wind_internal_energy = 1, wind_speed = 1 }"),
            "l1_density l1_velocity l1_pressure l1_internal_energy velocity_noise shock_width "
            "cloud_mass time_over_tau_kh ");
  EXPECT_EQ(names("sedov = { energy = 1, density = 1 }\ngresho = {}"),
            "l1_density shock_radius peak_density l1_velocity l1_velocity_profile ");
  EXPECT_EQ(names("noh = {}"), "l1_density density_behind_shock ");
}

TEST(GasMeasures, AreTheSameForAnyNumberOfThreads) {
  Scene<2> scene = test::gasBox<2>(0.5, 0.008);  // 15,625: several blocks of a sum
  scene.info.time = 0.1;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Vec<2>& x = scene.particles[field::position][i];
    scene.particles[field::velocity][i] = {{std::sin(7 * x[0]), std::cos(9 * x[1])}};
    test::setDensity(scene.particles, i, 1.5 + std::sin(50 * x[0] * x[1]));
    scene.particles[field::internalEnergy][i] = 1 + 0.3 * std::sin(20 * x[1]);
  }
  const SolverSettings solver = test::idealGas(1.4);
  const std::string text = R"(
order = false
riemann = { left = { density = 1, pressure = 1 }, right = { density = 0.125, pressure = 0.1 }, margin = 1 }
noh = {}
sedov = { energy = 0.01, density = 1 }
gresho = {}
cloud = { density = 2, radius = 0.2, wind_density = 1, wind_internal_energy = 1.2, wind_speed = 1 }
)";
  const auto settings = measureSection().read(CaseNode::parse(text, "case.toml"), 2);
  const auto rows = test::forThreads([&] {
    const auto state = test::observedGas(scene, solver);
    std::vector<Figure> row;
    Observers<2>(settings, state).addTo(row, state);
    return row;
  });
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (row[k].name == "shock_width") continue;  // empty: this gas has no front
      ASSERT_FALSE(std::isnan(row[k].value)) << row[k].name;
      EXPECT_EQ(row[k].value, rows.front()[k].value) << row[k].name;
    }
}

}  // namespace
}  // namespace plenum
