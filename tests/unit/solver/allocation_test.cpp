// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps allocate nothing: memory is the sum of the fields and does not fragment in a long run. Only
// searches may: in 3-D, lists of neighbours that grow longer than ever outgrow their room.
#include "solver/simulation.hpp"
#include "tests/support/walled_scene.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

namespace {
std::atomic<long> nAllocations{0};
}

namespace {
void* counted(void* memory) {
  ++nAllocations;
  if (memory != nullptr) return memory;
  throw std::bad_alloc();
}
// Not inlined: the compiler would take free() for a mismatch with the new that it sees.
[[gnu::noinline]] void release(void* memory) noexcept { std::free(memory); }
}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size)); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
// Those of AlignedVector.
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto line = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(line, (size + line - 1) / line * line));
}
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace plenum {
namespace {

template <int Dim>
void expectNoAllocation(Scene<Dim> scene, const SolverSettings& settings) {
  Simulation<Dim> simulation(std::move(scene), settings);
  const double dt = 0.1 * simulation.info().spacing / settings.soundSpeed;
  for (int k = 0; k < 30; ++k) simulation.step(dt);
  const std::size_t rebuildsBefore = simulation.engine().nRebuilds();
  const long before = nAllocations;
  for (int k = 0; k < 150; ++k) simulation.step(dt);
  EXPECT_EQ(nAllocations - before, 0);
  EXPECT_GT(simulation.engine().nRebuilds(), rebuildsBefore + 2) << "sorting was not exercised";
}

template <int Dim>
void expectNoAllocation(int perAxis, const SolverSettings& settings) {
  expectNoAllocation<Dim>(test::jitteredScene<Dim>(perAxis, true, 0.2, 1.0), settings);
}

TEST(Allocation, ThisProgramCountsThem) {
  const long before = nAllocations;
  AlignedVector<double> aligned(10);
  std::vector<double> plain(10);
  EXPECT_EQ(nAllocations - before, 2);
}

TEST(Allocation, AStepAllocatesNothing) {
  for (const char* precision : {"mixed", "double"}) {
    SCOPED_TRACE(precision);
    SolverSettings settings;
    settings.precision = precision;
    settings.viscosity = ViscositySettings{MonaghanSettings{}};
    settings.collisions = CollisionSettings{};
    expectNoAllocation<1>(100, settings);
    expectNoAllocation<2>(30, settings);
    expectNoAllocation<3>(12, settings);
    settings.density = "continuity";
    expectNoAllocation<2>(30, settings);
  }
}

/// Wall 0 moves along and wall 1 rocks.
template <int Dim>
Scene<Dim> movingWalls(int perAxis) {
  Scene<Dim> scene = test::walledScene<Dim>(perAxis, 0.2, 1.0);
  scene.info.walls[0].motion.velocity = {-0.1, 0, 0};
  scene.info.walls[1].motion.center = {0.5, 0.5, 0};
  scene.info.walls[1].motion.rocking = {0.02, {2}};
  return scene;
}

SolverSettings liquid(const std::string& precision, const std::string& walls,
                      const std::string& integrator, bool corrected) {
  SolverSettings settings;
  settings.precision = precision;
  settings.density = "continuity";
  settings.wallPressure = walls;
  settings.backgroundPressure = 20;
  settings.integrator = integrator;
  settings.viscosity = ViscositySettings{MonaghanSettings{}};
  settings.collisions = CollisionSettings{};
  if (!corrected) return settings;
  settings.viscosity->laminar = LaminarSettings{0.02};
  settings.densityDiffusion = DensityDiffusionSettings{};
  settings.shifting = ShiftingSettings{};
  return settings;
}

template <class Body>
void forEachLiquid(Body&& body) {
  for (const char* precision : {"mixed", "double"})
    for (const char* walls : {"zero", "initial", "equation_of_state", "extrapolated"})
      for (const char* integrator : {"symplectic_euler", "kick_drift_kick"})
        for (const bool corrected : {false, true}) {
          SCOPED_TRACE(std::string(precision) + " " + walls + " " + integrator +
                       (corrected ? " with diffusion and shifting" : ""));
          body(liquid(precision, walls, integrator, corrected));
        }
}

TEST(Allocation, NorDoesOneOfALiquidBesideWalls) {
  forEachLiquid([](const SolverSettings& settings) {
    expectNoAllocation<2>(test::walledScene<2>(20, 0.2, 1.0), settings);
    SCOPED_TRACE("moving");
    expectNoAllocation<2>(movingWalls<2>(20), settings);
  });
}

/// In a small box in 3-D lists of neighbours go on to outgrow their room now and then: here steps
/// that search anew may allocate.
TEST(Allocation, StepsIn3DAllocateOnlyWhereTheySearch) {
  forEachLiquid([](const SolverSettings& settings) {
    Simulation<3> simulation(movingWalls<3>(8), settings);
    const double dt = 0.1 * simulation.info().spacing / settings.soundSpeed;
    simulation.step(dt);
    for (int k = 0; k < 40; ++k) {
      const std::size_t rebuilds = simulation.engine().nRebuilds();
      const long before = nAllocations;
      simulation.step(dt);
      if (simulation.engine().nRebuilds() == rebuilds) {
        ASSERT_EQ(nAllocations - before, 0);
      }
    }
  });
}

}  // namespace
}  // namespace plenum
