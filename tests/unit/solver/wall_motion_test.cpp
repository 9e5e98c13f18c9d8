// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/wall_motion.hpp"

#include "particles/particle_file.hpp"
#include "solver/simulation.hpp"
#include "tests/support/random_particles.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace plenum {
namespace {

constexpr double pi = std::numbers::pi;

/// Three fluid particles and n of two walls, which take turns.
template <int Dim>
Scene<Dim> sceneWith(std::size_t n, const RigidMotion& first, const RigidMotion& second = {}) {
  Scene<Dim> scene;
  scene.particles = test::randomParticles<Dim>(test::unitBox<Dim>(false), 3, n);
  for (std::size_t k = 0; k < n; ++k) {
    scene.particles[field::wall][k] = static_cast<int>(k % 2);
    scene.particles[field::normal][k][0] = 1;
  }
  scene.info.walls.resize(2);
  scene.info.walls[0].motion = first;
  scene.info.walls[1].motion = second;
  return scene;
}

/// Turns, moves along, rocks, oscillates and follows a table.
RigidMotion wildMotion() {
  RigidMotion motion;
  motion.angularVelocity = {0, 0, 3.7};
  motion.velocity = {0.3, -0.1, 0};
  motion.center = {0.4, 0.6, 0};
  motion.oscillation = {{0.05, 0.02, 0}, {1.3, 0.2, 0.1, 7, 0.3}};
  motion.rocking = {0.2, {0.7, 0, 0.2, 9, 0}};
  motion.table = {{0, 1, 2.5, 6}, {{0, 0, 0, 0}, {0.1, 0, 0, 0.3}, {0.1, 0.2, 0, -0.2}, {}}};
  return motion;
}

template <int Dim>
std::vector<Vec<Dim>> copyOf(std::span<const Vec<Dim>> values) {
  return {values.begin(), values.end()};
}

TEST(WallMotion, RotationIsRigidAndExactAfterManyTurns) {
  RigidMotion turning;
  turning.angularVelocity = {0, 0, 2 * pi};  // one turn a second
  turning.center = {0.5, 0.5, 0};
  auto scene = sceneWith<2>(20, turning);
  ParticleSet<2>& particles = scene.particles;
  const auto before = copyOf<2>(particles[field::position]);
  WallMotion<2> motion(scene);
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
    const Vec<2> v = 2 * pi * Vec<2>{{-arm[0], -arm[1]}};
    EXPECT_LE(norm(particles[field::velocity][3 + k] - v), 1e-14);
  }
}

TEST(WallMotion, ShapesStayAsTheyAreAfterAMillionTurns) {
  RigidMotion turning;
  turning.angularVelocity = {0, 0, 2 * pi};
  turning.center = {0.5, 0.5, 0};
  auto scene = sceneWith<2>(20, turning, turning);
  const auto before = copyOf<2>(scene.particles[field::position]);
  WallMotion<2> motion(scene);
  motion.moveTo(1e6 + 0.1, scene.particles);
  const auto after = scene.particles[field::position];
  for (std::size_t i = 3; i < 23; ++i)
    for (std::size_t j = 3; j < i; ++j)  // round-off of places of the order of 1
      EXPECT_NEAR(norm(after[i] - after[j]), norm(before[i] - before[j]), 1e-15 * 4);
}

template <int Dim>
void expectDerivatives(const RigidMotion& rigid) {
  auto scene = sceneWith<Dim>(10, rigid, rigid);
  scene.info.time = 0.5;
  WallMotion<Dim> motion(scene);
  EXPECT_EQ(scene.info.startTime, 0.5);
  const ParticleSet<Dim>& particles = scene.particles;
  const auto at = [&](double time) {
    auto moved = particles;
    motion.moveTo(time, moved);
    return moved;
  };
  const double dt = 1e-5;  // central difference: error dt^2 |x'''|/6, about 1e-8 with |x'''| < 500
  const auto before = at(2 - dt), now = at(2), after = at(2 + dt);
  std::vector<Vec<Dim>> accelerations(10);
  motion.accelerations(2, now, accelerations);
  for (std::size_t k = 3; k < 13; ++k) {
    const Vec<Dim> slope = (after[field::position][k] - before[field::position][k]) / (2 * dt);
    EXPECT_LE(norm(slope - now[field::velocity][k]), 1e-8);
    const Vec<Dim> change = (after[field::velocity][k] - before[field::velocity][k]) / (2 * dt);
    EXPECT_LE(norm(change - accelerations[k - 3]), 1e-7);
    EXPECT_LE(norm(accelerations[k - 3] - motion.acceleration(0, now[field::position][k], 2)),
              1e-13);  // round-off of the place, times rates below 100
  }
  const auto start = at(0.5);
  for (std::size_t k = 3; k < 13; ++k)
    EXPECT_LE(norm(start[field::position][k] - particles[field::position][k]), 1e-15);
}

TEST(WallMotion, VelocityAndAccelerationAreDerivatives) {
  expectDerivatives<2>(wildMotion());
  expectDerivatives<3>(wildMotion());
  RigidMotion screw;
  screw.angularVelocity = {0.3, -0.7, 1.1};
  screw.velocity = {0.2, 0.1, -0.4};
  screw.center = {0.1, 0.2, 0.3};
  expectDerivatives<3>(screw);
}

TEST(WallMotion, StaysInAPeriodicDomain) {
  RigidMotion lid;
  lid.velocity = {1, 0, 0};
  lid.oscillation = {{0, 0.5, 0}, {0.25, 0, 0, 1, 0}};  // a quarter: half a metre up, and stay
  auto scene = sceneWith<2>(5, lid, lid);
  const auto before = scene.particles;
  const Box<2> domain = test::unitBox<2>(true);
  scene.info.domain = domain;
  WallMotion<2> motion(scene);
  motion.moveTo(3.25, scene.particles);
  for (std::size_t k = 3; k < 8; ++k) {
    EXPECT_TRUE(domain.contains(scene.particles[field::position][k]));
    const Vec<2> path = scene.particles[field::position][k] - before[field::position][k];
    EXPECT_LE(norm(domain.nearestImage(path - Vec<2>{{0.25, 0.5}})), 1e-14);  // round-off of 3.25
    EXPECT_LE(norm(scene.particles[field::velocity][k] - Vec<2>{{1, 0}}), 1e-15);
  }
}

TEST(WallMotion, ReturnsTheLongestWay) {
  RigidMotion shaking;
  shaking.oscillation = {{0.3, 0, 0}, {0.25, 0, 0, 1, 0}};
  auto scene = sceneWith<2>(6, {}, shaking);
  WallMotion<2> motion(scene);
  EXPECT_TRUE(motion.anyMoves());
  EXPECT_NEAR(motion.moveTo(1, scene.particles), 0.3, 1e-15);  // round-off
  EXPECT_EQ(motion.moveTo(2, scene.particles), 0);             // it stands still since then
}

TEST(WallMotion, TheSameBitsHoweverOftenARunWasResumed) {
  const test::TemporaryFolder folder;
  auto whole = sceneWith<2>(20, wildMotion(), {{0, 0, 0}, {0, 0, -1.7}, {0.1, 0.2, 0}});
  whole.info.spacing = 0.1;
  whole.info.domain = test::unitBox<2>(true);
  auto parts = whole;
  WallMotion<2>(whole).moveTo(5.123, whole.particles);
  for (const double time : {0.1, 1.7, 1.8, 4.4}) {
    WallMotion<2>(parts).moveTo(time, parts.particles);
    parts.info.time = time;
    writeParticleFile(folder / "state.hdf", parts);
    parts = readParticleFile<2>(folder / "state.hdf");
    EXPECT_EQ(parts.info.startTime, 0);
  }
  WallMotion<2>(parts).moveTo(5.123, parts.particles);
  for (std::size_t k = 0; k < whole.particles.size(); ++k) {
    EXPECT_EQ(parts.particles[field::position][k], whole.particles[field::position][k]);
    EXPECT_EQ(parts.particles[field::velocity][k], whole.particles[field::velocity][k]);
  }
  for (std::size_t k = 0; k < 20; ++k)
    EXPECT_EQ(parts.particles[field::normal][k], whole.particles[field::normal][k]);
}

TEST(WallMotion, NeedsNoIdsAndFollowsParticlesThatAreSorted) {
  auto scene = sceneWith<2>(8, wildMotion());
  auto straight = scene;
  WallMotion<2> motion(scene), same(straight);
  ParticleSet<2>& particles = scene.particles;
  particles.remove({field::id});
  const std::vector<std::uint32_t> order{2, 0, 1, 10, 3, 9, 4, 8, 5, 7, 6};
  std::vector<std::byte> scratch(particles.size() * ParticleSet<2>::permuteBytes);
  particles.permute(order, scratch);
  motion.moveTo(1.5, particles);
  same.moveTo(1.5, straight.particles);
  for (std::size_t k = 0; k < order.size(); ++k)
    EXPECT_EQ(particles[field::position][k], straight.particles[field::position][order[k]]);
}

TEST(WallMotion, StillWallsCarryNoReference) {
  auto scene = sceneWith<2>(8, {});
  const auto before = copyOf<2>(scene.particles[field::position]);
  WallMotion<2> motion(scene);
  EXPECT_FALSE(motion.anyMoves());
  EXPECT_FALSE(scene.particles.has(field::referencePosition));
  EXPECT_EQ(motion.moveTo(1, scene.particles), 0);
  EXPECT_EQ(copyOf<2>(scene.particles[field::position]), before);
}

/// A row of fluid between two walls of four layers each.
Scene<1> channel(const RigidMotion& lower) {
  Scene<1> scene;
  const double d = 0.1;
  scene.info.spacing = d;
  scene.info.materials = {{"water", 1}};
  scene.info.walls = {{"lower", "lattice", 4, 4 * d, 1, lower},
                      {"upper", "lattice", 4, 4 * d, 1, {}}};
  scene.particles =
      ParticleSet<1>({field::position, field::velocity, field::mass, field::density,
                      field::pressure, field::id, field::wall, field::normal, field::wallDistance},
                     10, 8);
  for (std::size_t i = 0; i < 18; ++i) {
    const bool isFluid = i < 10, isLower = i < 14;
    const double k = static_cast<double>(isFluid ? i : isLower ? i - 10 : i - 14) + 0.5;
    const double x = isFluid ? k * d : isLower ? -k * d : 1 + k * d;
    scene.particles[field::position][i] = {{x}};
    scene.particles[field::mass][i] = d;
    scene.particles[field::density][i] = 1;
    scene.particles[field::id][i] = isFluid ? i + 9 : i - 9;
    if (isFluid) continue;
    scene.particles[field::wall][i - 10] = isLower ? 0 : 1;
    scene.particles[field::normal][i - 10] = {{isLower ? 1.0 : -1.0}};
    scene.particles[field::wallDistance][i - 10] = k * d;
  }
  scene.info.domain.lower = {{-0.4}};
  scene.info.domain.upper = {{1.4}};
  return scene;
}

TEST(WallMotion, ASimulationKeepsTheReferenceIfAWallMoves) {
  RigidMotion piston;
  piston.oscillation = {{0.01, 0, 0}, {1, 0, 0, 1e3, 0}};
  SolverSettings settings;
  for (const RigidMotion& motion : {RigidMotion{}, piston}) {
    Simulation<1> simulation(channel(motion), settings);
    for (int k = 0; k < 5; ++k) simulation.step(1e-3);
    const ParticleSet<1>& particles = simulation.particles();
    EXPECT_EQ(particles.has(field::referencePosition), !motion.isStill());
    EXPECT_EQ(particles.has(field::referenceNormal), !motion.isStill());
    for (std::size_t k = 0; k < 8 && !motion.isStill(); ++k) {
      const double way = particles[field::wall][k] == 0 ? 0.01 * std::sin(2 * pi * 5e-3) : 0;
      const double went =
          particles[field::position][10 + k][0] - particles[field::referencePosition][k][0];
      EXPECT_NEAR(went, way, 1e-15);  // round-off of places of the order of 1
    }
  }
}

}  // namespace
}  // namespace plenum
