// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps allocate nothing: memory is the sum of the fields and does not fragment in a long run. Only
// while a lattice loses its order, in the first steps, may lists of neighbours outgrow their room.
#include "solver/simulation.hpp"
#include "tests/support/jittered_scene.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> nAllocations{0};
}

void* operator new(std::size_t size) {
  ++nAllocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace plenum {
namespace {

template <int Dim>
void expectNoAllocation(int perAxis, const SolverSettings& settings) {
  Simulation<Dim> simulation(test::jitteredScene<Dim>(perAxis, true, 0.2, 1.0), settings);
  const double dt = 0.1 / (perAxis * settings.soundSpeed);
  for (int k = 0; k < 30; ++k) simulation.step(dt);
  const std::size_t rebuildsBefore = simulation.engine().nRebuilds();
  const long before = nAllocations;
  for (int k = 0; k < 150; ++k) simulation.step(dt);
  EXPECT_EQ(nAllocations - before, 0);
  EXPECT_GT(simulation.engine().nRebuilds(), rebuildsBefore + 2) << "sorting was not exercised";
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

}  // namespace
}  // namespace plenum
