// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volumes, the pressure of a column, and flows that are known: particles that carry the exact
// state measure no error, and known errors as large as they are.
#include "solver/measures/box_volume.hpp"
#include "solver/measures/couette.hpp"
#include "solver/measures/pressure_gradient.hpp"
#include "solver/measures/taylor_green.hpp"
#include "tests/unit/solver/measures/water.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

TEST(BoxVolume, AddsTheVolumesOfThoseInside) {
  Scene<2> scene = test::stillWater<2>({{1, 0.6}}, 0.05, 2);
  const auto volume = [&](const VolumeSettings& settings) {
    const auto state = test::observed(scene);
    std::vector<Figure> row;
    BoxVolume<2>(settings, state, "measures.volume[0]").addTo(row, state);
    EXPECT_EQ(row.at(0).unit, "m^2");
    return row.at(0).value;
  };
  // Sums of at most 240 terms: so many roundings.
  EXPECT_NEAR(volume({"v", {-1, -1}, {2, 2}, ""}), 0.6, 0.6 * 240 * 1.1e-16);
  EXPECT_NEAR(volume({"v", {0.5, 0}, {1, 0.3}, "water"}), 0.15, 0.15 * 240 * 1.1e-16);
  EXPECT_EQ(volume({"v", {2, 2}, {3, 3}, ""}), 0);
  EXPECT_NE(test::refusalOf([&] {
              volume({"v", {0, 0}, {1, 1}, "oil"});
            }).find("no such fluid"),
            std::string::npos);
}

class Column : public testing::Test {
 protected:
  Column() {
    for (std::size_t i = 0; i < scene.particles.size(); ++i)
      scene.particles[field::pressure][i] =
          1e5 + 1000 * 9.81 * (1 - scene.particles[field::position][i][1]);
  }
  double error(const PressureGradientSettings& settings = {}) const {
    const auto state = test::observed(scene);
    std::vector<Figure> row;
    PressureGradient<2>(settings, state, "measures.pressure_gradient").addTo(row, state);
    EXPECT_EQ(row.at(0).name, "pressure_gradient_error");
    return row.at(0).value;
  }
  Scene<2> scene = test::stillWater<2>({{0.2, 1}}, 0.05, 2);
};

TEST_F(Column, AtRestHasNoError) {
  // In per cent; 1e5 Pa in double, over 1e4 Pa of the column: 1e-15 and some roundings.
  EXPECT_LT(std::abs(error()), 1e-11);
  // The slope of 1.02 p is 2 % too steep, whatever is added to it.
  for (double& p : scene.particles[field::pressure]) p *= 1.02;
  EXPECT_NEAR(error(), 2, 1e-10);
  for (double& p : scene.particles[field::pressure]) p /= -1.02;
  EXPECT_NEAR(error(), -200, 1e-10);  // it falls with depth
}

TEST_F(Column, OnlyTheMiddleCounts) {
  for (std::size_t i = 0; i < scene.particles.nFluid(); ++i) {
    const double y = scene.particles[field::position][i][1];
    if (y < 0.1 || y > 0.9) scene.particles[field::pressure][i] = 0;
  }
  EXPECT_LT(std::abs(error()), 1e-11);
  EXPECT_GT(std::abs(error({1.0, {}, {}, ""})), 1);
  EXPECT_GT(std::abs(error({0.8, -0.2, 1.0, ""})), 1);
  EXPECT_LT(std::abs(error({1.0, 0.2, 0.8, ""})), 1e-11);
}

TEST_F(Column, OneOfSeveralFluidsMustBeChosen) {
  scene.info.materials.push_back({"oil", 800});
  EXPECT_EQ(test::refusalOf([&] { error(); }),
            "measures.pressure_gradient: the scene has 2 fluids: choose one by "
            "measures.pressure_gradient.material = \"water\"");
}

TEST_F(Column, WithoutParticlesAtTwoHeightsItIsEmpty) {
  EXPECT_TRUE(std::isnan(error({0.01, 0.0, 0.05, ""})));
}

class Vortices : public testing::Test {
 protected:
  Vortices() {
    scene.info.time = 0.3;
    for (std::size_t i = 0; i < scene.particles.size(); ++i) {
      const Vec<2>& x = scene.particles[field::position][i];
      scene.particles[field::velocity][i] = exact.velocity(x, 0.3);
      scene.particles[field::pressure][i] = exact.pressure(x, 0.3, 1000) + 500;
    }
  }
  std::pair<double, double> errors() const {
    std::vector<Figure> row;
    exact.addTo(row, test::observed(scene));
    EXPECT_EQ(row.at(0).name, "l1_velocity");
    EXPECT_EQ(row.at(1).name, "l1_pressure");
    return {row[0].value, row[1].value};
  }
  Scene<2> scene = test::stillWater<2>({{1, 1}}, 0.05);
  TaylorGreen exact{{2, 1, 0.01, {}}};
};

TEST_F(Vortices, TheExactFlowHasNoError) {
  // Pressures of 1e3 shifted by 500: a thousand of roundings 1e-16.
  EXPECT_EQ(errors().first, 0);
  EXPECT_LT(errors().second, 1e-13);
}

TEST_F(Vortices, ErrorsAreRelative) {
  for (auto& v : scene.particles[field::velocity]) v *= 1.1;
  for (double& p : scene.particles[field::pressure]) p = 0.8 * p - 1e3;
  EXPECT_NEAR(errors().first, 0.1, 1e-13);
  EXPECT_NEAR(errors().second, 0.2, 1e-13);
}

TEST_F(Vortices, DecayAndSolveTheEquations) {
  // Central differences of step 1e-4 of a flow with k = 2 pi: truncation (k step)^2/6 = 7e-8 of
  // terms of size U^2 k = 25, rounding 1e-16/1e-8 of second derivatives times nu = 0.01.
  const double s = 1e-4, t = 0.2, nu = 0.01, rho = 3;
  const Vec<2> x{{0.13, 0.29}};
  const auto u = [&](double dx, double dy, double dt) {
    return exact.velocity(x + Vec<2>{{dx, dy}}, t + dt);
  };
  const Vec<2> v = u(0, 0, 0), vx = (u(s, 0, 0) - u(-s, 0, 0)) / (2 * s);
  const Vec<2> vy = (u(0, s, 0) - u(0, -s, 0)) / (2 * s), vt = (u(0, 0, s) - u(0, 0, -s)) / (2 * s);
  const Vec<2> laplace = (u(s, 0, 0) + u(-s, 0, 0) + u(0, s, 0) + u(0, -s, 0) - 4.0 * v) / (s * s);
  const auto p = [&](double dx, double dy) {
    return exact.pressure(x + Vec<2>{{dx, dy}}, t, rho) / rho;
  };
  const Vec<2> gradP{{(p(s, 0) - p(-s, 0)) / (2 * s), (p(0, s) - p(0, -s)) / (2 * s)}};
  const Vec<2> rest = vt + v[0] * vx + v[1] * vy + gradP - nu * laplace;
  EXPECT_NEAR(vx[0] + vy[1], 0, 1e-5);
  EXPECT_NEAR(rest[0], 0, 1e-5);
  EXPECT_NEAR(rest[1], 0, 1e-5);
}

class Cylinders : public testing::Test {
 protected:
  Cylinders() {
    for (std::size_t i = 0; i < scene.particles.size(); ++i) {
      const Vec<2> r = scene.particles[field::position][i] - Vec<2>{{0.5, 0.5}};
      const double radius = norm(r);
      scene.particles[field::velocity][i] = exact.speed(radius) / radius * Vec<2>{{-r[1], r[0]}};
    }
  }
  std::pair<double, double> errors() const {
    std::vector<Figure> row;
    exact.addTo(row, test::observed(scene));
    EXPECT_EQ(row.at(1).name, "couette_profile_error");
    return {row[0].value, row[1].value};
  }
  Scene<2> scene = test::stillWater<2>({{1, 1}}, 0.05);  // even: no particle at the centre
  Couette exact{{{0.5, 0.5}, 0.1, 0.5, 4, -1, 10}};
};

TEST_F(Cylinders, TurnWithTheirSurfaces) {
  EXPECT_DOUBLE_EQ(exact.speed(0.1), 0.4);
  EXPECT_DOUBLE_EQ(exact.speed(0.5), -0.5);
  // The torque 2 pi r^2 mu r d(u/r)/dr is the same at all radii; differences of step 1e-5 leave
  // (step/r)^2 = 1e-8 of it.
  const auto torque = [&](double r) {
    const double s = 1e-5;
    return r * r * r * (exact.speed(r + s) / (r + s) - exact.speed(r - s) / (r - s)) / (2 * s);
  };
  EXPECT_NEAR(torque(0.2), torque(0.4), 1e-6 * std::abs(torque(0.2)));
}

TEST_F(Cylinders, TheExactFlowHasNoError) {
  EXPECT_EQ(errors().first, 0);
  EXPECT_LT(errors().second, 1e-15);  // roundings of speeds below 1
}

TEST_F(Cylinders, ErrorsAreRelative) {
  for (auto& v : scene.particles[field::velocity]) v *= 1.1;
  EXPECT_NEAR(errors().first, 0.1, 1e-13);
  // A tenth of the speed in the worst ring, which is next to a cylinder: the largest speed is 0.5
  // at the outer one, the mean over a ring 0.04 wide a little less.
  EXPECT_NEAR(errors().second, 0.1, 0.01);
}

}  // namespace
}  // namespace plenum
