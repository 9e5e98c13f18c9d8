// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/preflight.hpp"

#include "particles/errors.hpp"
#include "solver/simulation.hpp"
#include "tests/support/jittered_scene.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace plenum {
namespace {

/// The message of the error that this scene causes, "" if there is none.
std::string refusal(const Scene<2>& scene, const SolverSettings& settings = {}) {
  try {
    Simulation<2> simulation(scene, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

Scene<2> gas() { return test::jitteredScene<2>(10, false); }

TEST(Preflight, AcceptsASoundScene) { EXPECT_EQ(refusal(gas()), ""); }

TEST(Preflight, RefusesAnEmptySet) {
  Scene<2> scene = gas();
  scene.particles = ParticleSet<2>(scene.particles.fields(), 0, 0);
  EXPECT_NE(refusal(scene).find("no fluid particle"), std::string::npos);
}

TEST(Preflight, RefusesExtrapolatedWallsOfAGasWithoutADensityAtRest) {
  Scene<2> scene = gas();
  SolverSettings settings;
  settings.density = "continuity";
  settings.wallPressure = "extrapolated";
  settings.backgroundPressure = 2 * settings.soundSpeed * settings.soundSpeed;
  EXPECT_EQ(refusal(scene, settings), "") << "there are no walls";
  scene.info.walls = {{"tank", "lattice", 4, 1, 1.0, {}}};
  EXPECT_NE(refusal(scene, settings).find("has no density at pressure 0"), std::string::npos)
      << refusal(scene, settings);
}

TEST(Preflight, RefusesALiquidThatCavitatesAtItsReferenceDensity) {
  SolverSettings settings;
  settings.backgroundPressure = 2;
  settings.cavitationPressure = 2;
  EXPECT_EQ(refusal(gas(), settings), "");
  settings.cavitationPressure = 3;
  EXPECT_NE(refusal(gas(), settings).find("cavitation_pressure = 3 is above"), std::string::npos)
      << refusal(gas(), settings);
}

TEST(Preflight, NamesTheMissingField) {
  Scene<2> scene = gas();
  scene.particles.remove({field::mass});
  EXPECT_NE(refusal(scene).find("mass (Masses)"), std::string::npos);
}

TEST(Preflight, NamesTheParticleWithABadValue) {
  Scene<2> scene = gas();
  scene.particles[field::mass][4] = -1;
  EXPECT_NE(refusal(scene).find("particle 5: mass = -1"), std::string::npos);
  scene = gas();
  scene.particles[field::position][6][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(scene).find("particle 7: position"), std::string::npos);
  scene = gas();
  scene.particles[field::position][8][0] = -1e30;
  EXPECT_NE(refusal(scene).find("particle 9: position = -1e+30 m"), std::string::npos);
}

TEST(Preflight, RefusesSmoothingLengthsThatDiffer) {
  Scene<2> scene = gas();
  scene.particles.add({field::smoothingLength});
  for (double& h : scene.particles[field::smoothingLength]) h = 0.15;
  EXPECT_EQ(refusal(scene), "");
  scene.particles[field::smoothingLength][3] = 0.075;
  EXPECT_NE(refusal(scene).find("from 0.075 to 0.15 m"), std::string::npos) << refusal(scene);
}

TEST(Preflight, NamesTheMissingLayersOfAThinWall) {
  Scene<2> scene = gas();
  scene.info.walls = {{"floor", "lattice", 2, 0.2, 1.0, {}}, {"roof", "lattice", 4, 0.4, 1.0, {}}};
  SolverSettings settings;
  settings.smoothingLength = 1.5;  // support 3 d_ref = 0.3 m
  const std::string message = refusal(scene, settings);
  EXPECT_NE(message.find("wall \"floor\" is 0.2 m thick, 1 layer of 0.1 m short"),
            std::string::npos)
      << message;
  EXPECT_EQ(message.find("roof"), std::string::npos);
  settings.smoothingLength = 1;
  EXPECT_EQ(refusal(scene, settings), "");
}

TEST(Preflight, WallsWhoseDensityIsSummedNeedTwiceTheSupport) {
  Scene<2> scene = gas();
  scene.info.walls = {{"floor", "lattice", 4, 0.4, 1.0, {}}};
  SolverSettings settings;
  settings.wallPressure = "equation_of_state";
  EXPECT_NE(refusal(scene, settings).find("2 layers"), std::string::npos);
  settings.density = "continuity";
  EXPECT_EQ(refusal(scene, settings), "");
}

TEST(Preflight, RefusesCollisionsBeyondTheSupport) {
  SolverSettings settings;
  settings.smoothingLength = 0.7;
  settings.collisions = CollisionSettings{0.01, 1.5, "all"};
  EXPECT_NE(refusal(gas(), settings).find("solver.collisions.range"), std::string::npos);
}

TEST(Simulation, StopsBeforeANonFiniteForceMovesAnything) {
  SolverSettings settings;
  settings.viscosity = ViscositySettings{MonaghanSettings{1, 1}};
  Scene<2> scene = gas();
  scene.particles[field::velocity][44] = {{1e200, 0}};  // its square overflows in mu^2
  const std::vector<Vec<2>> before(scene.particles[field::position].begin(),
                                   scene.particles[field::position].end());
  Simulation<2> simulation(std::move(scene), settings);
  try {
    simulation.step(1e-4);
    FAIL() << "no error";
  } catch (const RunError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("particle ")) << message;
    EXPECT_NE(message.find("the force is not finite"), std::string::npos) << message;
    EXPECT_NE(message.find("t = "), std::string::npos) << message;
  }
  const auto order = test::byId(simulation.particles());
  for (std::size_t k = 0; k < order.size(); ++k)
    EXPECT_EQ(simulation.particles()[field::position][order[k]], before[k]);
}

TEST(Simulation, StopsWhenTheTimeStepVanishes) {
  Scene<2> scene = gas();
  scene.particles[field::velocity][12] = {{1e9, 0}};
  Simulation<2> simulation(std::move(scene), SolverSettings{});
  try {
    simulation.advanceTo(1.0, [] {});
    FAIL() << "no error";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("particle 13"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("cfl time step"), std::string::npos);
  }
}

TEST(Simulation, StopsBeforeADensityTurnsNegative) {
  SolverSettings settings;
  settings.density = "continuity";
  Scene<2> scene = gas();
  for (std::size_t i = 0; i < scene.particles.size(); ++i)  // everything flies apart
    scene.particles[field::velocity][i] =
        100.0 * (scene.particles[field::position][i] - scene.info.domain.center());
  Simulation<2> simulation(std::move(scene), settings);
  try {
    simulation.step(0.1);
    FAIL() << "no error";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("density"), std::string::npos) << error.what();
  }
  for (const double rho : simulation.particles()[field::density]) EXPECT_GT(rho, 0);
}

TEST(Preflight, RefusesTwoDensitiesAndOneEquationOfState) {
  Scene<2> scene = gas();
  scene.info.materials = {{"water", 1000, 20.0}, {"air", 1}};
  scene.particles.add({field::material});
  const std::string message = refusal(scene);
  EXPECT_NE(message.find("fluid \"air\" has no sound_speed"), std::string::npos) << message;
  scene.info.materials[1].soundSpeed = 340;
  EXPECT_EQ(refusal(scene), "");
}

TEST(Preflight, RefusesDiffusionWhereItHasNoMeaning) {
  Scene<2> scene = gas();
  SolverSettings settings;
  settings.densityDiffusion = DensityDiffusionSettings{};
  EXPECT_NE(refusal(scene, settings).find("solver.density = \"continuity\""), std::string::npos);
  settings.density = "continuity";
  EXPECT_EQ(refusal(scene, settings), "");
  scene.info.materials = {{"water", 1000, 20.0}, {"air", 1, 20.0}};
  scene.particles.add({field::material});
  EXPECT_NE(refusal(scene, settings).find("mix the densities"), std::string::npos);
}

/// The message with which a step stops.
std::string failure(Scene<2> scene, const SolverSettings& settings, double dt) {
  try {
    Simulation<2> simulation(std::move(scene), settings);
    for (int k = 0; k < 10; ++k) simulation.step(dt);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(Preflight, RefusesAStepAboveItsLimit) {
  SolverSettings settings;  // h = .15 m, c = 10 m/s
  settings.timeStep = 0.0301;
  EXPECT_NE(refusal(gas(), settings).find("longer than its limit 0.03 s"), std::string::npos);
  settings.timeStep = 0.03;
  EXPECT_EQ(refusal(gas(), settings), "");
  settings.viscosity = ViscositySettings{{}, LaminarSettings{1}};
  EXPECT_NE(refusal(gas(), settings).find("longer than its limit 0.0225 s"), std::string::npos);
}

TEST(Preflight, AStepStopsBeforeItDoesHarm) {
  SolverSettings settings;
  Scene<2> fast = gas();
  fast.particles[field::velocity][4] = {{60, 0}};
  const std::string tooFast = failure(fast, settings, 1e-5);
  EXPECT_NE(tooFast.find("particle 5 at"), std::string::npos) << tooFast;
  EXPECT_NE(tooFast.find("above solver.speed_limit = 5 c at t = 0 s"), std::string::npos)
      << tooFast;

  Scene<2> bursting = gas();  // all fly apart: rho (1 - dt div v) < 0
  for (std::size_t i = 0; i < bursting.particles.size(); ++i)
    bursting.particles[field::velocity][i] =
        30.0 * (bursting.particles[field::position][i] - Vec<2>{{0.5, 0.5}});
  settings.density = "continuity";
  const std::string burst = failure(bursting, settings, 0.02);
  EXPECT_NE(burst.find("the density is no longer positive"), std::string::npos) << burst;
  EXPECT_NE(burst.find("likely a time step that is too large"), std::string::npos) << burst;
}

}  // namespace
}  // namespace plenum
