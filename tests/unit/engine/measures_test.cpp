// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/measures.hpp"

#include "engine/voids.hpp"

#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum {
namespace {

constexpr double d = 0.05;

/// A hexagonal lattice that fits a periodic box exactly.
Scene<2> hexagonal() {
  Scene<2> scene;
  const int nx = 20, ny = 24;
  const double row = std::sqrt(3.0) / 2 * d;
  scene.info.spacing = d;
  scene.info.domain.upper = {{nx * d, ny * row}};
  scene.info.domain.periodic = {true, true};
  scene.particles = ParticleSet<2>({field::position}, nx * ny, 0);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      scene.particles[field::position][static_cast<std::size_t>(j * nx + i)] = {
          {(i + 0.25 + 0.5 * (j % 2)) * d, (j + 0.5) * row}};
  return scene;
}

TEST(Measures, PerfectHexagonalLattice) {
  const Scene<2> scene = hexagonal();
  const auto m = measureSpacing(scene.particles, scene.info.domain, d);
  EXPECT_NEAR(m.minNearest, 1, 1e-12);  // round-off of coordinates
  EXPECT_NEAR(m.meanNearest, 1, 1e-12);
  EXPECT_NEAR(m.psi6, 1, 1e-12);
  EXPECT_EQ(m.below085, 0);
  // The largest hole of a perfect hexagonal lattice is 0.577 d_ref.
  EXPECT_EQ(measureVoids(scene.particles, scene.info, false), 0);
}

TEST(Measures, APairCountsTwice) {
  Scene<2> scene = hexagonal();
  auto x = scene.particles[field::position];
  const auto n = static_cast<double>(x.size());
  x[0] = x[1] + Vec<2>{{0.04 * d, 0}};
  const auto m = measureSpacing(scene.particles, scene.info.domain, d);
  EXPECT_NEAR(m.minNearest, 0.04, 1e-12);
  EXPECT_DOUBLE_EQ(m.below01, 2 / n);
  EXPECT_DOUBLE_EQ(m.below05, 2 / n);
}

TEST(Measures, AHoleHasItsArea) {
  Scene<2> scene = hexagonal();
  auto& p = scene.particles;
  const Vec<2> center{{0.5, 0.5}};
  const double radius = 0.2;
  std::vector<Vec<2>> kept;
  for (const Vec<2>& x : p[field::position])
    if (norm(x - center) > radius) kept.push_back(x);
  ParticleSet<2> with({field::position}, kept.size(), 0);
  std::ranges::copy(kept, with[field::position].begin());
  const double share = measureVoids(with, scene.info, false);
  // Points within d_ref of the rim are no holes; the rim itself is ragged by half a spacing.
  const double inner = std::numbers::pi * std::pow(radius - d, 2) / scene.info.domain.volume();
  const double outer = std::numbers::pi * std::pow(radius - d / 2, 2) / scene.info.domain.volume();
  EXPECT_GT(share, inner * 0.95);
  EXPECT_LT(share, outer * 1.05);
}

TEST(Measures, AFreeSurfaceIsNoHole) {
  Scene<2> scene = hexagonal();
  scene.info.domain.periodic = {false, false};
  auto& p = scene.particles;
  std::vector<Vec<2>> lower;
  for (const Vec<2>& x : p[field::position])
    if (x[1] < 0.5) lower.push_back(x);
  ParticleSet<2> half({field::position}, lower.size(), 0);
  std::ranges::copy(lower, half[field::position].begin());
  EXPECT_GT(measureVoids(half, scene.info, false), 0.4);
  EXPECT_EQ(measureVoids(half, scene.info, true), 0);
}

TEST(Measures, CountsParticlesThatLeftTheContainer) {
  Scene<2> scene = hexagonal();
  SceneInfo<2>& info = scene.info;
  info.domain.periodic = {false, false};
  // The container is the half plane y < 0.5, sampled on a grid of d/2.
  ContainerMap<2>& map = info.container;
  map.spacing = d / 2;
  map.step = d / 32;
  map.shape = {50, 50};
  for (int j = 0; j < 50; ++j)
    for (int i = 0; i < 50; ++i) {
      const double distance = (j + 0.5) * d / 2 - 0.5;
      map.counts.push_back(
          static_cast<std::int8_t>(std::clamp(std::nearbyint(distance / map.step), -127.0, 127.0)));
    }
  std::size_t expected = 0;
  for (const Vec<2>& x : scene.particles[field::position]) expected += x[1] > 0.5 + 0.5 * d;
  EXPECT_GT(expected, 100u);
  EXPECT_EQ(countLeft(scene.particles, info), expected);
}

/// A container that all walls carry along moves with them.
TEST(Measures, TheContainerMovesWithTheWalls) {
  Scene<2> scene;
  scene.info.spacing = 0.1;
  scene.info.domain.lower = {{-0.4, -0.4}};
  scene.info.domain.upper = {{1.4, 1.4}};
  scene.particles = test::randomParticles<2>(test::unitBox<2>(false), 200, 0);
  ContainerMap<2>& map = scene.info.container;  // the unit box, by its distance along x
  map.lower = {{-1, -1}};
  map.spacing = 0.05;
  map.step = 0.01;
  map.shape = {60, 60};
  for (int k = 0; k < 3600; ++k)
    map.counts.push_back(static_cast<std::int8_t>(
        std::clamp(100 * (std::abs((k % 60 + 0.5) * 0.05 - 1.5) - 0.5), -127.0, 127.0)));
  scene.info.walls = {{"vessel", "lattice", 4, 0.4, 1.0, {}}};
  EXPECT_EQ(countLeft(scene.particles, scene.info), 0u);
  EXPECT_EQ(countEscaped(scene.particles, scene.info), 0u);
  for (Vec<2>& x : scene.particles[field::position]) x[0] += 3;
  EXPECT_EQ(countLeft(scene.particles, scene.info), 200u);
  EXPECT_EQ(countEscaped(scene.particles, scene.info), 200u);
  scene.info.walls[0].motion.velocity = {1.5, 0, 0};
  scene.info.time = 2;
  EXPECT_EQ(countLeft(scene.particles, scene.info), 0u) << "the vessel went with them";
  EXPECT_EQ(countEscaped(scene.particles, scene.info), 0u);
  scene.particles[field::position][7][1] = 9;
  EXPECT_EQ(countEscaped(scene.particles, scene.info), 1u);
}

}  // namespace
}  // namespace plenum
