// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the fluid feels of walls, and they of it.
#include "solver/wall_state.hpp"

#include "solver/conserved.hpp"
#include "solver/simulation.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/support/walled_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum {
namespace {

template <class T>
class WallStateTest : public testing::Test {};
TYPED_TEST_SUITE(WallStateTest, test::Dimensions);

constexpr int perAxis(int dim) { return dim == 3 ? 8 : 16; }

SolverSettings liquid(const std::string& wallPressure, int dim) {
  SolverSettings settings;
  settings.precision = "double";
  settings.density = "continuity";
  settings.soundSpeed = 10;
  settings.wallPressure = wallPressure;
  settings.gravity.assign(static_cast<std::size_t>(dim), 0.0);
  settings.gravity.back() = -1;
  return settings;
}

template <int Dim>
double hydrostatic(const Vec<Dim>& x) {
  return 0.02 * 100 + 1 * (1 - x[Dim - 1]);  // p of density 1 under gravity 1, and a little more
}

/// With one density p_w = sum (p_f + rho g . r_wf) V W/sum V W is exact for any arrangement.
TYPED_TEST(WallStateTest, ExtrapolatedPressureIsHydrostatic) {
  constexpr int dim = TypeParam::value;
  Scene<dim> scene = test::walledScene<dim>(perAxis(dim), 0.2, 0);
  const SolverSettings settings = liquid("extrapolated", dim);
  const Tait state{1, 10, 0, 1};
  typename Engine<dim>::Options options;
  options.support = 2 * 1.5 * scene.info.spacing;
  options.wallsReceive = true;
  options.precision = Precision::doubled;
  Engine<dim> engine(scene.info.domain, options);
  engine.update(scene.particles);
  for (std::size_t i = 0; i < scene.particles.nFluid(); ++i)
    scene.particles[field::pressure][i] = hydrostatic(scene.particles[field::position][i]);
  const Phases phases(scene.info.materials, settings);
  const auto passes = selectPasses<dim>(settings, phases, {scene.info.spacing, true, false}, {});
  Vec<dim> gravity;
  gravity[dim - 1] = -1;
  WallState<dim> walls(settings, MaterialTable({state, state}), gravity);
  walls.update(engine, passes.atWalls, scene.particles, {});

  std::size_t nSeen = 0;
  const double reach = options.support;
  for (std::size_t i = scene.particles.nFluid(); i < scene.particles.size(); ++i) {
    const Vec<dim> x = scene.particles[field::position][i];
    const double p = scene.particles[field::pressure][i];
    EXPECT_DOUBLE_EQ(scene.particles[field::density][i], state.density(p));
    double outside = 0;
    for (int a = 0; a < dim; ++a) outside = std::max({outside, -x[a], x[a] - 1});
    if (outside > 0.5 * reach) continue;  // corners and back layers may have nobody near
    bool nearCorner = false;
    for (int a = 0; a < dim; ++a) nearCorner = nearCorner || x[a] < 0 || x[a] > 1;
    int nOut = 0;
    for (int a = 0; a < dim; ++a) nOut += x[a] < 0 || x[a] > 1;
    if (nOut > 1) continue;
    ++nSeen;
    EXPECT_NEAR(p, hydrostatic(x), 1e-11);  // sums of some dozen numbers of about 1, over .01
  }
  EXPECT_GT(nSeen, 0u);
}

/// A wall that falls with the fluid feels no weight: g - a_w.
TEST(WallState, AcceleratedWallsFeelTheDifferenceToGravity) {
  Scene<2> scene = test::walledScene<2>(16, 0, 0);
  const SolverSettings settings = liquid("extrapolated", 2);
  Engine<2>::Options options;
  options.support = 3 * scene.info.spacing;
  options.wallsReceive = true;
  options.precision = Precision::doubled;
  Engine<2> engine(scene.info.domain, options);
  engine.update(scene.particles);
  std::ranges::fill(scene.particles[field::pressure], 5.0);
  const Phases phases(scene.info.materials, settings);
  const auto passes = selectPasses<2>(settings, phases, {scene.info.spacing, true, false}, {});
  const Tait state{1, 10, 0, 1};
  WallState<2> walls(settings, MaterialTable({state, state}), {{0, -1}});
  const std::vector<Vec<2>> falling(scene.particles.nWalls(), {{0, -1}});
  walls.update(engine, passes.atWalls, scene.particles, {.accelerations = falling});
  std::size_t nSeen = 0;
  for (std::size_t i = scene.particles.nFluid(); i < scene.particles.size(); ++i) {
    const double p = scene.particles[field::pressure][i];
    if (p == 0) continue;  // nobody near
    ++nSeen;
    EXPECT_NEAR(p, 5.0, 1e-13);  // a mean of 5.0s
  }
  EXPECT_GE(nSeen, 4u * 16 * 2);  // two layers on each of four sides are within reach, 3 spacings
}

/// What the walls get and gravity takes is what the fluid loses, step by step.
TYPED_TEST(WallStateTest, LoadsAccountForAllMomentum) {
  constexpr int dim = TypeParam::value;
  for (const char* walls : {"zero", "initial", "equation_of_state", "extrapolated"})
    for (const char* pairs : {"", "all", "wall"})
      for (const char* integrator : {"symplectic_euler", "kick_drift_kick"}) {
        SCOPED_TRACE(std::string(walls) + " " + pairs + " " + integrator);
        SolverSettings settings = liquid(walls, dim);
        settings.backgroundPressure = 5;
        settings.viscosity = ViscositySettings{MonaghanSettings{0.5, 1.0}};
        settings.integrator = integrator;
        if (*pairs != 0) settings.collisions = CollisionSettings{0.01, 0.9, pairs};
        Simulation<dim> simulation(test::walledScene<dim>(perAxis(dim)), settings, true);
        const Conserved before = measureConserved(simulation);
        const double dt = 0.1 * simulation.smoothingLength() / settings.soundSpeed;
        constexpr int nSteps = 20;
        for (int k = 0; k < nSteps; ++k) simulation.step(dt);
        const Conserved after = measureConserved(simulation);
        WallLoad total;
        for (const WallLoad& load : simulation.wallLoads()) total += load;
        EXPECT_NE(total.force[dim - 1], 0);
        for (int a = 0; a < dim; ++a) {
          const auto k = static_cast<std::size_t>(a);
          const double weight = a == dim - 1 ? -before.mass : 0;
          const double expected = before.momentum[k] + nSteps * dt * (weight - total.force[k]);
          // Sums over some hundred particles and steps of impulses of some hundredths.
          EXPECT_NEAR(after.momentum[k], expected, 1e-13);
        }
      }
}

TEST(WallState, AFluidSticksToAMovingWall) {
  Scene<2> scene = test::walledScene<2>(16, 0, 0);
  for (std::size_t i = scene.particles.nFluid(); i < scene.particles.size(); ++i)
    scene.particles[field::velocity][i] = {{2, 0}};
  for (std::size_t i = 0; i < scene.particles.nFluid(); ++i)
    scene.particles[field::velocity][i] = {{1, 0.5}};
  SolverSettings settings = liquid("zero", 2);
  settings.viscosity = ViscositySettings{{}, LaminarSettings{1e-3}};
  const Simulation<2> simulation(std::move(scene), settings);
  const ParticleSet<2>& p = simulation.particles();
  ASSERT_TRUE(p.has(field::slipVelocity));
  std::size_t nSeen = 0;
  for (std::size_t k = 0; k < p.nWalls(); ++k) {
    const Vec<2> slip = p[field::slipVelocity][k];
    EXPECT_EQ(p[field::velocity][p.nFluid() + k], (Vec<2>{{2, 0}})) << "walls keep their own";
    if (slip == Vec<2>{{2, 0}}) continue;  // nobody near
    ++nSeen;
    EXPECT_NEAR(slip[0], 3, 1e-6);  // 2 v_w - v_f, by pairs in float
    EXPECT_NEAR(slip[1], -0.5, 1e-6);
  }
  EXPECT_GT(nSeen, 100u);
}

/// Fluid at rest sees 2 v_s, v_s the velocity of the surface, not of the particles behind it.
TEST(WallState, AFluidSticksToTheSurfaceOfATurningWall) {
  constexpr double omega = 3, depth = 0.1;
  Scene<2> scene = test::walledScene<2>(16, 0, 0);
  std::ranges::fill(scene.particles[field::wallDistance], depth);
  for (std::size_t i = scene.particles.nFluid(); i < scene.particles.size(); ++i) {
    const Vec<2>& x = scene.particles[field::position][i];
    scene.particles[field::velocity][i] = {{-omega * x[1], omega * x[0]}};
  }
  for (std::size_t i = 0; i < scene.particles.nFluid(); ++i)
    scene.particles[field::velocity][i] = {};
  for (Wall& wall : scene.info.walls) wall.motion.angularVelocity = {0, 0, omega};
  SolverSettings settings = liquid("zero", 2);
  settings.precision = "double";
  settings.viscosity = ViscositySettings{{}, LaminarSettings{1e-3}};
  const Simulation<2> simulation(std::move(scene), settings);
  const ParticleSet<2>& p = simulation.particles();
  std::size_t nSeen = 0;
  for (std::size_t k = 0; k < p.nWalls(); ++k) {
    const Vec<2> slip = p[field::slipVelocity][k];
    if (slip == p[field::velocity][p.nFluid() + k]) continue;  // nobody near
    ++nSeen;
    const Vec<2> surface = p[field::position][p.nFluid() + k] + depth * p[field::normal][k];
    EXPECT_NEAR(slip[0], -2 * omega * surface[1], 1e-13);  // some roundings of numbers of about 6
    EXPECT_NEAR(slip[1], 2 * omega * surface[0], 1e-13);
  }
  EXPECT_GT(nSeen, 100u);
}

}  // namespace
}  // namespace plenum
