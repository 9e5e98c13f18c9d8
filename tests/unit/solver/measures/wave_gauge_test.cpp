// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/wave_gauge.hpp"

#include "tests/unit/solver/measures/water.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace plenum {
namespace {

template <int Dim>
double heightAt(const Observed<Dim>& state, const std::vector<double>& place,
                std::optional<double> dry = {}) {
  std::vector<Figure> row;
  WaveGauge<Dim>({"h", place, dry}, state, reachOf(state), "measures.gauge[0]")
      .addTo(row, Interpolation<Dim>(state));
  EXPECT_EQ(row.at(0).name, "h");
  EXPECT_EQ(row.at(0).unit, "m");
  return row.at(0).value;
}

TEST(WaveGauge, FindsTheSurfaceOfStillWater) {
  // The kernel's mean over a half space is a half at its edge; rows of particles make it wave by
  // less than a third of a spacing, whatever the spacing, the kernel and the place between columns.
  for (const double d : {0.1, 0.05, 0.02})
    for (const char* kernel : {"cubic_spline", "wendland_c2", "convex"}) {
      const Scene<2> scene = test::stillWater<2>({{1, 0.6}}, d);
      for (const double x : {0.5, 0.5 + 0.3 * d})
        EXPECT_NEAR(heightAt(test::observed(scene, kernel), {x}), 0.6, d / 3) << d << kernel;
    }
  const Scene<3> scene = test::stillWater<3>({{0.8, 0.8, 0.4}}, 0.1);
  EXPECT_NEAR(heightAt(test::observed(scene), {0.4, 0.37}), 0.4, 0.1 / 3);
}

TEST(WaveGauge, FindsItBesideAWallToo) {
  const double d = 0.05;
  Scene<2> scene = test::stillWater<2>({{1, 0.6}}, d, 4);
  // Half of the kernel is wall there; its layers reach above the water.
  for (const double x : {0.0, 0.02, 0.1, 1.0})
    EXPECT_NEAR(heightAt(test::observed(scene), {x}), 0.6, d / 3) << x;
}

TEST(WaveGauge, OfOneFluidFindsItsInterface) {
  const double d = 0.05;
  Scene<2> scene = test::stillWater<2>({{1, 0.6}}, d);
  scene.info.materials = {{"water", 1000}, {"oil", 900}};
  scene.particles.add({field::material});
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    scene.particles[field::material][i] = scene.particles[field::position][i][1] > 0.3 ? 1 : 0;
  const auto state = test::observed(scene);
  const auto height = [&](const std::string& material) {
    std::vector<Figure> row;
    WaveGauge<2>({"h", {0.5}, {}, material}, state, reachOf(state), "measures.gauge[0]")
        .addTo(row, Interpolation<2>(state));
    return row.at(0).value;
  };
  EXPECT_NEAR(height("water"), 0.3, d / 3);  // as above
  EXPECT_NEAR(height("oil"), 0.6, d / 3);
  EXPECT_NEAR(height(""), 0.6, d / 3);
}

TEST(WaveGauge, UpIsAgainstGravity) {
  const Scene<2> scene = test::stillWater<2>({{1, 0.6}}, 0.05);
  auto state = test::observed(scene);
  state.gravity = {{0, 9.81}};  // the surface is below
  EXPECT_NEAR(heightAt(state, {0.5}), 0.0, 0.05 / 3);
  state.gravity = {{-1, 0}};  // the gauge's place is then a height y
  EXPECT_NEAR(heightAt(state, {0.3}), 1.0, 0.05 / 3);
}

TEST(WaveGauge, ADropletAboveIsNoSurface) {
  Scene<2> scene = test::stillWater<2>({{1, 0.6}}, 0.05);
  const std::size_t top = 10 * 12 + 11;  // of the column in the middle
  ASSERT_NEAR(scene.particles[field::position][top][1], 0.575, 1e-12);
  const double before = heightAt(test::observed(scene), {0.025});
  scene.particles[field::position][top] = {{0.025, 1e7}};  // and no long search up there
  EXPECT_NEAR(heightAt(test::observed(scene), {0.025}), before, 1e-9);
}

TEST(WaveGauge, DryPlaces) {
  Scene<2> scene = test::stillWater<2>({{1, 0.6}}, 0.05);
  for (auto& x : scene.particles[field::position])
    if (x[0] > 0.5 && x[0] < 0.9) x[0] -= 0.45;
  EXPECT_TRUE(std::isnan(heightAt(test::observed(scene), {0.7})));
  EXPECT_EQ(heightAt(test::observed(scene), {0.7}, -0.1), -0.1);
}

TEST(WaveGauge, BadInputIsRefused) {
  const Scene<2> scene = test::stillWater<2>({{1, 0.6}}, 0.05);
  auto state = test::observed(scene);
  std::string message = test::refusalOf([&] { heightAt(state, {1.2}); });
  EXPECT_NE(message.find("measures.gauge[0] \"h\": x = 1.2 m lies outside"), std::string::npos)
      << message;
  for (const Vec<2>& gravity : {Vec<2>{}, Vec<2>{{1, -1}}}) {
    state.gravity = gravity;
    message = test::refusalOf([&] { heightAt(state, {0.5}); });
    EXPECT_NE(message.find("set solver.gravity along one axis"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace plenum
