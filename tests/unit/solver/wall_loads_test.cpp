// SPDX-License-Identifier: GPL-3.0-or-later
//
// Torques on walls. For forces see WallStateTest.LoadsAccountForAllMomentum.
#include "solver/wall_loads.hpp"

#include "solver/conserved.hpp"
#include "solver/simulation.hpp"
#include "tests/support/walled_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace plenum {
namespace {

using Three = std::array<double, 3>;

Three cross(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void add(Three& sum, double factor, const Three& v) {
  for (std::size_t a = 0; a < 3; ++a) sum[a] += factor * v[a];
}

/// Wall 0 moves along and so does its centre; wall 1 rocks about a centre that is not the origin.
template <int Dim>
Scene<Dim> movingScene() {
  Scene<Dim> scene = test::walledScene<Dim>(Dim == 3 ? 8 : 16);
  scene.info.walls[0].motion.center = {-0.3, 0.2, 0.1};
  scene.info.walls[0].motion.velocity = {0.5, 0.25, 0};
  scene.info.walls[1].motion.center = {0.7, 0.4, 0};
  scene.info.walls[1].motion.rocking = {0.02, {3}};
  return scene;
}

Three centerAt(const Wall& wall, double time) {
  Three center = wall.motion.center;
  add(center, time, wall.motion.velocity);
  return center;
}

/// Torque of gravity about the origin on the fluid where it is now.
template <int Dim>
Three torqueOfGravity(const Simulation<Dim>& simulation) {
  const ParticleSet<Dim>& p = simulation.particles();
  Three sum{};
  for (std::size_t i = 0; i < p.nFluid(); ++i)
    add(sum, p[field::mass][i],
        cross(toThree(p[field::position][i]), toThree(simulation.gravity())));
  return sum;
}

/// The force on a wall that acts at first in the next step of kick-drift-kick.
template <int Dim>
Three forceNow(Simulation<Dim>& simulation, std::size_t wall) {
  simulation.notePause();
  Three force{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::string name = "wall_" + std::to_string(wall) + "_force_" + "xyz"[a];
    const auto& progress = simulation.info().progress;
    const auto found =
        std::ranges::find(progress, name, [](const auto& figure) { return figure.first; });
    if (found == progress.end())
      ADD_FAILURE() << name;
    else
      force[a] = found->second;
  }
  return force;
}

/// One step; returns the angular momentum about the origin that the walls got in it.
///
/// Symplectic Euler exchanges all where the particles are at the beginning. Kick-drift-kick
/// exchanges half of the first force there, and the rest at the end.
template <int Dim>
Three stepped(Simulation<Dim>& simulation, double dt) {
  const std::vector<Wall>& walls = simulation.info().walls;
  const bool kicksTwice = simulation.settings().kicksTwice();
  const double begin = simulation.time();
  std::vector<Three> first;
  for (std::size_t w = 0; w < walls.size() && kicksTwice; ++w)
    first.push_back(forceNow(simulation, w));
  simulation.restartWallLoads();
  simulation.step(dt);
  const std::vector<WallLoad> loads = simulation.wallLoads();
  Three sum{};
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const Three center = centerAt(walls[w], begin + (kicksTwice ? dt : 0));
    add(sum, dt, loads[w].torque);
    add(sum, dt, cross(center, loads[w].force));
    if (!kicksTwice) continue;
    Three way = centerAt(walls[w], begin);
    add(way, -1, center);
    add(sum, dt / 2, cross(way, first[w]));
  }
  return sum;
}

/// All forces of these settings point along the line between two particles, and x changes by dt v:
/// angular momentum goes to the walls or comes from gravity.
template <int Dim>
void expectLoadsAccountForAngularMomentum(Scene<Dim> scene, const SolverSettings& settings) {
  Simulation<Dim> simulation(std::move(scene), settings, true);
  const Conserved before = measureConserved(simulation);
  const double dt = 0.1 * simulation.smoothingLength() / settings.soundSpeed;
  Three toWalls{}, ofGravity{};
  for (int k = 0; k < 20; ++k) {
    add(ofGravity, settings.kicksTwice() ? dt / 2 : dt, torqueOfGravity(simulation));
    add(toWalls, 1, stepped(simulation, dt));
    if (settings.kicksTwice()) add(ofGravity, dt / 2, torqueOfGravity(simulation));
  }
  const Conserved after = measureConserved(simulation);
  for (std::size_t a = Dim == 2 ? 2 : 0; a < 3; ++a) {
    EXPECT_GT(std::abs(toWalls[a]), 1e-5) << "nothing to account for";
    const double expected = before.angularMomentum[a] + ofGravity[a] - toWalls[a];
    // Sums over some hundred particles and steps of impulses of some hundredths, arms of about 1.
    EXPECT_NEAR(after.angularMomentum[a], expected, 1e-13);
  }
}

template <int Dim>
void expectLoadsAccountForAngularMomentum() {
  for (const char* walls : {"zero", "initial", "equation_of_state", "extrapolated"})
    for (const char* pairs : {"", "all", "wall"})
      for (const char* integrator : {"symplectic_euler", "kick_drift_kick"})
        for (const bool moving : {false, true}) {
          SCOPED_TRACE(std::string(walls) + " " + pairs + " " + integrator +
                       (moving ? " moving" : " still"));
          SolverSettings settings;
          settings.precision = "double";
          settings.density = "continuity";
          settings.wallPressure = walls;
          settings.backgroundPressure = 5;
          settings.gravity.assign(Dim, 0.0);
          settings.gravity.back() = -1;
          settings.viscosity = ViscositySettings{MonaghanSettings{0.5, 1.0}};
          settings.integrator = integrator;
          if (*pairs != 0) settings.collisions = CollisionSettings{0.01, 0.9, pairs};
          expectLoadsAccountForAngularMomentum(
              moving ? movingScene<Dim>() : test::walledScene<Dim>(Dim == 3 ? 8 : 16), settings);
        }
}

TEST(WallLoads, TorquesAccountForAllAngularMomentumIn2D) {
  expectLoadsAccountForAngularMomentum<2>();
}
TEST(WallLoads, TorquesAccountForAllAngularMomentumIn3D) {
  expectLoadsAccountForAngularMomentum<3>();
}

}  // namespace
}  // namespace plenum
