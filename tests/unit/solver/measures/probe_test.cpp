// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/probe.hpp"

#include "tests/unit/solver/measures/water.hpp"

#include <gtest/gtest.h>

#include <random>

namespace plenum {
namespace {

constexpr double d = 0.05;

template <int Dim>
std::vector<Figure> figuresAt(const Scene<Dim>& scene, const std::vector<double>& point) {
  const auto state = test::observed(scene);
  std::vector<Figure> row;
  Probe<Dim>({"p", point}, state, reachOf(state), "measures.probe[0]")
      .addTo(row, Interpolation<Dim>(state));
  return row;
}

void jitter(Scene<2>& scene, double size) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> uniform(-size, size);
  for (auto& x : scene.particles[field::position])
    x += Vec<2>{{uniform(generator), uniform(generator)}};
}

TEST(Probe, AConstantComesBackExactlyOnAnyParticles) {
  Scene<2> scene = test::stillWater<2>({{1, 1}}, d);
  jitter(scene, 0.4 * d);
  for (double& p : scene.particles[field::pressure]) p = 1234.5;
  for (auto& v : scene.particles[field::velocity]) v = {{2, -3}};
  for (const auto& point : {std::vector{0.51, 0.48}, {0.02, 0.03}, {0.5, 0.99}}) {
    const auto row = figuresAt(scene, point);
    ASSERT_EQ(row.size(), 3u);
    EXPECT_EQ(row[0].name, "p_pressure");
    EXPECT_EQ(row[0].unit, "Pa m");
    EXPECT_EQ(row[2].name, "p_velocity_y");
    // A weighted mean of some 30 equal numbers: 30 roundings at most.
    EXPECT_NEAR(row[0].value, 1234.5, 1234.5 * 30 * 1.1e-16);
    EXPECT_NEAR(row[1].value, 2, 2 * 30 * 1.1e-16);
    EXPECT_NEAR(row[2].value, -3, 3 * 30 * 1.1e-16);
  }
}

TEST(Probe, ALinearFieldOnALatticeIsExactWhereTheLatticeIsSymmetric) {
  Scene<2> scene = test::stillWater<2>({{1, 1}}, d);
  const auto linear = [](const Vec<2>& x) { return 100 + 30 * x[0] - 70 * x[1]; };
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    scene.particles[field::pressure][i] = linear(scene.particles[field::position][i]);
  // On a particle, in the middle of four and in the middle of two, first moments cancel.
  for (const auto& x : {Vec<2>{{0.525, 0.475}}, Vec<2>{{0.5, 0.5}}, Vec<2>{{0.5, 0.525}}})
    EXPECT_NEAR(figuresAt(scene, {x[0], x[1]})[0].value, linear(x), 1e-12 * 200);
  // Elsewhere the first moment of the lattice is left, for C2 at h = 1.5 d below 2 % of d.
  const Vec<2> x{{0.511, 0.487}};
  EXPECT_NEAR(figuresAt(scene, {x[0], x[1]})[0].value, linear(x), 0.02 * d * (30 + 70));
}

TEST(Probe, WallsDoNotCount) {
  Scene<2> scene = test::stillWater<2>({{1, 1}}, d, 3);
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    scene.particles[field::pressure][i] = i < scene.particles.nFluid() ? 5 : 1e9;
  // In the corner of the box a quarter of the place is fluid. Ten roundings of a mean.
  EXPECT_NEAR(figuresAt(scene, {0.0, 0.0})[0].value, 5, 5e-15);
}

TEST(Probe, IsEmptyWithoutFluid) {
  Scene<2> scene = test::stillWater<2>({{1, 0.2}}, d, 3);
  scene.info.domain.upper[1] = 2;
  scene.info.domain.periodic = {false, true};  // so that a point above the water is in the scene
  for (const Figure& f : figuresAt(scene, {0.5, 1.0})) EXPECT_TRUE(std::isnan(f.value)) << f.name;
  EXPECT_FALSE(std::isnan(figuresAt(scene, {0.5, 0.1})[0].value));
}

TEST(Probe, SeesThroughPeriodicBoundaries) {
  Scene<1> scene = test::stillWater<1>({{1}}, d);
  scene.info.domain.lower = {{0}};
  scene.info.domain.upper = {{1}};
  scene.info.domain.periodic = {true};
  for (double& p : scene.particles[field::pressure]) p = 7;
  const FluidChoice all("", scene.info, "");
  EXPECT_NEAR(Interpolation<1>(test::observed(scene)).at({{0}}, all).fluid,
              Interpolation<1>(test::observed(scene)).at({{0.5}}, all).fluid,
              1e-14);  // some roundings
  EXPECT_NEAR(figuresAt(scene, {1.0})[0].value, 7, 1e-14);
}

TEST(Probe, OutsideOfTheSceneIsRefused) {
  const Scene<2> scene = test::stillWater<2>({{1, 1}}, d, 2);
  const std::string message = test::refusalOf([&] { figuresAt(scene, {0.5, 1.2}); });
  EXPECT_NE(message.find("measures.probe[0] \"p\": point = (0.5, 1.2) m lies outside"),
            std::string::npos)
      << message;
  EXPECT_EQ(test::refusalOf([&] { figuresAt(scene, {-0.06, 1.05}); }), "no error");  // in the wall
}

}  // namespace
}  // namespace plenum
