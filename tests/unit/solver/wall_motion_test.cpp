// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/wall_motion.hpp"

#include "particles/errors.hpp"
#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

template <int Dim>
ParticleSet<Dim> walls(std::size_t n) {
  auto particles = test::randomParticles<Dim>(test::unitBox<Dim>(false), 3, n);
  for (std::size_t k = 0; k < n; ++k) {
    particles[field::wall][k] = static_cast<int>(k % 2);
    particles[field::normal][k][0] = 1;
  }
  return particles;
}

TEST(WallMotion, RotationIsRigidAndExactAfterManyTurns) {
  auto particles = walls<2>(20);
  Wall shaft, housing;
  shaft.motion.angularVelocity = {0, 0, 2 * std::numbers::pi};  // one turn a second
  shaft.motion.center = {0.5, 0.5, 0};
  const std::vector<Vec<2>> before(particles[field::position].begin(),
                                   particles[field::position].end());
  WallMotion<2> motion({shaft, housing}, particles, {}, 0.0);
  for (int k = 1; k <= 4000; ++k) motion.moveTo(k * 0.25, particles);  // ends after 1000 turns
  for (std::size_t k = 0; k < 20; ++k)  // sin(2 pi 1000) is 2.5e-13 in double
    EXPECT_LE(norm(particles[field::position][3 + k] - before[3 + k]), 1e-12);

  motion.moveTo(0.25, particles);
  for (std::size_t k = 0; k < 20; ++k) {
    const Vec<2> arm = before[3 + k] - Vec<2>{{0.5, 0.5}};
    const bool turns = k % 2 == 0;
    const Vec<2> expected = turns ? Vec<2>{{0.5 - arm[1], 0.5 + arm[0]}} : before[3 + k];
    EXPECT_LE(norm(particles[field::position][3 + k] - expected), 1e-15 * 8);
    if (!turns) continue;
    EXPECT_LE(norm(particles[field::normal][k] - Vec<2>{{0, 1}}), 1e-15);
    const Vec<2> v = 2 * std::numbers::pi * Vec<2>{{-arm[0], -arm[1]}};
    EXPECT_LE(norm(particles[field::velocity][3 + k] - v), 1e-14);
  }
}

TEST(WallMotion, VelocityIsTheDerivativeOfThePosition) {
  auto particles = walls<3>(10);
  Wall wall;
  wall.motion.angularVelocity = {0.3, -0.7, 1.1};
  wall.motion.velocity = {0.2, 0.1, -0.4};
  wall.motion.center = {0.1, 0.2, 0.3};
  WallMotion<3> motion({wall, wall}, particles, {}, 0.5);
  const auto at = [&](double time) {
    auto moved = particles;
    motion.moveTo(time, moved);
    return moved;
  };
  const double dt = 1e-5;  // central difference: error dt^2 |x'''|/6, about 1e-10
  const auto before = at(2 - dt), now = at(2), after = at(2 + dt);
  for (std::size_t k = 3; k < 13; ++k) {
    const Vec<3> slope = (after[field::position][k] - before[field::position][k]) / (2 * dt);
    EXPECT_LE(norm(slope - now[field::velocity][k]), 1e-9);
  }
  const auto start = at(0.5);
  for (std::size_t k = 3; k < 13; ++k)
    EXPECT_LE(norm(start[field::position][k] - particles[field::position][k]), 1e-15);
}

TEST(WallMotion, StaysInAPeriodicDomain) {
  auto particles = walls<2>(5);
  const auto before = particles;
  Wall lid;
  lid.motion.velocity = {1, 0, 0};
  const Box<2> domain = test::unitBox<2>(true);
  WallMotion<2> motion({lid, lid}, particles, domain, 0);
  motion.moveTo(3.25, particles);
  for (std::size_t k = 3; k < 8; ++k) {
    EXPECT_TRUE(domain.contains(particles[field::position][k]));
    const Vec<2> path = particles[field::position][k] - before[field::position][k];
    EXPECT_LE(norm(domain.nearestImage(path - Vec<2>{{0.25, 0}})), 1e-14);  // round-off of 3.25
  }
}

TEST(WallMotion, RefusesWallIdsWithGaps) {
  auto particles = walls<2>(5);
  particles[field::id][4] = 100;
  Wall wall;
  wall.motion.velocity = {1, 0, 0};
  EXPECT_THROW(WallMotion<2>({wall, wall}, particles, {}, 0), InputError);
}

}  // namespace
}  // namespace plenum
