// SPDX-License-Identifier: GPL-3.0-or-later
//
// Order of the integrators in time, and runs that stop and go on.
#include "particles/particle_file.hpp"
#include "solver/conserved.hpp"
#include "solver/simulation.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/threads.hpp"
#include "tests/support/walled_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>

namespace plenum {
namespace {

SolverSettings gas(const std::string& integrator, const std::string& density) {
  SolverSettings settings;
  settings.precision = "double";
  settings.integrator = integrator;
  settings.density = density;
  settings.backgroundPressure = 100;
  return settings;
}

/// Positions at t = .02 s, a good part of the time that sound needs through the box, by id.
std::vector<Vec<2>> end(const SolverSettings& settings, int nSteps) {
  Simulation<2> simulation(test::jitteredScene<2>(16, true, 0.02, 0.5), settings);
  for (int k = 0; k < nSteps; ++k) simulation.step(0.02 / nSteps);
  const ParticleSet<2>& p = simulation.particles();
  std::vector<Vec<2>> positions(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) positions[p[field::id][i] - 1] = p[field::position][i];
  return positions;
}

double distance(const std::vector<Vec<2>>& a, const std::vector<Vec<2>>& b) {
  const Box<2> box = test::unitBox<2>(true);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += normSquared(box.nearestImage(a[i] - b[i]));
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Halving the step divides the difference to the next finer one by 2^order. The gas has no
/// viscosity: its switch between approaching and receding pairs is of first order.
double order(const SolverSettings& settings) {
  const auto coarse = end(settings, 40), middle = end(settings, 80), fine = end(settings, 160);
  return std::log2(distance(coarse, middle) / distance(middle, fine));
}

TEST(Integrators, SymplecticEulerIsOfFirstOrder) {
  for (const char* density : {"summation", "continuity"})
    EXPECT_NEAR(order(gas("symplectic_euler", density)), 1, 0.15) << density;  // higher terms
}

TEST(Integrators, KickDriftKickIsOfSecondOrder) {
  for (const char* density : {"summation", "continuity"})
    EXPECT_NEAR(order(gas("kick_drift_kick", density)), 2, 0.15) << density;  // higher terms
}

/// A scene with everything that a state may have.
SolverSettings liquid(const std::string& integrator, const std::string& walls) {
  SolverSettings settings;
  settings.integrator = integrator;
  settings.density = "continuity";
  settings.wallPressure = walls;
  settings.backgroundPressure = 20;
  settings.viscosity = ViscositySettings{MonaghanSettings{0.2, 0}};
  settings.gravity = {0, -1};
  return settings;
}

Scene<2> shakenScene() {
  Scene<2> scene = test::walledScene<2>(20);
  scene.info.walls[1].motion.velocity = {-0.3, 0, 0};
  for (std::size_t k = 0; k < scene.particles.nWalls(); ++k)
    if (scene.particles[field::wall][k] == 1)
      scene.particles[field::velocity][scene.particles.nFluid() + k] = {{-0.3, 0}};
  return scene;
}

/// Wall 1 rocks, fast at first, about the middle of the box.
Scene<2> rockingScene() {
  Scene<2> scene = test::walledScene<2>(20);
  RigidMotion& motion = scene.info.walls[1].motion;
  motion.center = {0.5, 0.5, 0};
  motion.rocking = {0.02, {2}};
  const MotionState state(motion, 0);
  for (std::size_t k = 0; k < scene.particles.nWalls(); ++k) {
    const std::size_t i = scene.particles.nFluid() + k;
    if (scene.particles[field::wall][k] == 1)
      scene.particles[field::velocity][i] = state.velocityAt(scene.particles[field::position][i]);
  }
  std::ranges::fill(scene.particles[field::wallDistance], 0.05);
  return scene;
}

void expectSameBits(const Simulation<2>& a, const Simulation<2>& b) {
  EXPECT_EQ(a.time(), b.time());
  EXPECT_EQ(a.nSteps(), b.nSteps());
  EXPECT_EQ(a.maxTimeStep(), b.maxTimeStep());
  ASSERT_TRUE(a.particles().fields() == b.particles().fields());
  a.particles().forEachField([&](const FieldInfo& info, auto values) {
    if (!info.isState) return;
    b.particles().forEachField([&](const FieldInfo& other, auto others) {
      if constexpr (std::is_same_v<decltype(values), decltype(others)>) {
        if (other.id != info.id) return;
        EXPECT_EQ(std::memcmp(values.data(), others.data(), values.size_bytes()), 0) << info.name;
      }
    });
  });
}

/// Steps until the run may stop, at least `n`; its state goes through a file.
Simulation<2> paused(Simulation<2>& simulation, int n, const SolverSettings& settings) {
  for (int k = 0; k < n || !simulation.mayPause(); ++k) simulation.step(simulation.maxTimeStep());
  simulation.notePause();
  const test::TemporaryFolder folder;
  writeParticleFile(folder / "pause.hdf", simulation.scene());
  return Simulation<2>(readParticleFile<2>(folder / "pause.hdf"), settings, true);
}

/// A run that was paused after about n steps and one that was not, 100 steps later.
void expectSameAfterPause(Scene<2> scene, int n, const SolverSettings& settings) {
  Simulation<2> simulation(std::move(scene), settings, true);
  Simulation<2> resumed = paused(simulation, n, settings);
  EXPECT_TRUE(resumed.isContinued());
  const double begin = simulation.time();
  for (int k = 0; k < 100; ++k)
    for (Simulation<2>* run : {&simulation, &resumed}) run->step(run->maxTimeStep());
  EXPECT_GT(simulation.engine().nRebuilds(), 1u);
  EXPECT_GT(simulation.time(), begin);
  expectSameBits(simulation, resumed);
  const auto loads = simulation.wallLoads(), same = resumed.wallLoads();
  ASSERT_EQ(loads.size(), same.size());
  for (std::size_t w = 0; w < loads.size(); ++w) {
    EXPECT_EQ(loads[w].force, same[w].force);
    EXPECT_EQ(loads[w].torque, same[w].torque);
    EXPECT_NE(loads[w].torque[2], 0);
  }
}

TEST(Integrators, ARunThatStoppedGoesOnWithTheSameBits) {
  std::vector<SolverSettings> all;
  for (const char* integrator : {"symplectic_euler", "kick_drift_kick"})
    for (const char* walls : {"zero", "initial", "equation_of_state", "extrapolated"})
      all.push_back(liquid(integrator, walls));
  all.push_back(all.front());
  all.back().collisions = CollisionSettings{};
  all.push_back(all.back());
  all.back().density = "summation";
  all.push_back(all[3]);
  all.back().viscosity->laminar = LaminarSettings{0.02};
  all.back().densityDiffusion = DensityDiffusionSettings{};
  all.back().shifting = ShiftingSettings{};
  for (std::size_t k = 0; k < all.size(); ++k) {
    SCOPED_TRACE(k);
    expectSameAfterPause(shakenScene(), 10 + 7 * static_cast<int>(k), all[k]);
  }
}

/// What the second kick, the slip of a turning wall and the moments of the density read.
TEST(Integrators, ARunWithARockingWallThatStoppedGoesOnWithTheSameBits) {
  for (const char* walls : {"zero", "initial", "equation_of_state", "extrapolated"}) {
    SCOPED_TRACE(walls);
    SolverSettings settings = liquid("kick_drift_kick", walls);
    settings.viscosity->laminar = LaminarSettings{0.02};
    settings.densityDiffusion = DensityDiffusionSettings{};
    settings.shifting = ShiftingSettings{};
    expectSameAfterPause(rockingScene(), 30, settings);
  }
}

TEST(Integrators, ARunMayPauseOftenEnough) {
  Simulation<2> simulation(test::walledScene<2>(10, 0, 0), liquid("symplectic_euler", "zero"));
  int longest = 0, since = 0;
  for (int k = 0; k < 200; ++k) {
    simulation.step(simulation.maxTimeStep());
    longest = std::max(longest, ++since);
    if (simulation.mayPause()) since = 0;
  }
  EXPECT_LE(longest, 64);
}

}  // namespace
}  // namespace plenum
