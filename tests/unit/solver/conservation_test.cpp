// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/kernels.hpp"
#include "solver/conserved.hpp"
#include "solver/simulation.hpp"
#include "solver/state_row.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/support/jittered_scene.hpp"
#include "tests/support/permute.hpp"
#include "tests/support/threads.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <random>

namespace plenum {
namespace {

template <class T>
class ConservationTest : public testing::Test {};
TYPED_TEST_SUITE(ConservationTest, test::Dimensions);

constexpr const char* bothPrecisions[] = {"mixed", "double"};

constexpr int perAxis(int dim) { return dim == 1 ? 60 : dim == 2 ? 20 : 9; }

SolverSettings settingsWith(const std::string& precision, const std::string& density, bool viscous,
                            bool colliding) {
  SolverSettings settings;
  settings.precision = precision;
  settings.density = density;
  if (viscous) settings.viscosity = ViscositySettings{MonaghanSettings{0.5, 1.0}};
  if (colliding) settings.collisions = CollisionSettings{};
  return settings;
}

/// Steps a gas and compares what must not change; both in units of mass x sound speed (x length).
/// Returns the largest change.
template <int Dim>
double expectConserved(const SolverSettings& settings, bool periodic) {
  Simulation<Dim> simulation(test::jitteredScene<Dim>(perAxis(Dim), periodic), settings);
  const Conserved before = measureConserved(simulation);
  const double dt = 0.1 * simulation.smoothingLength() / settings.soundSpeed;
  for (int k = 0; k < 50; ++k) simulation.step(dt);
  const Conserved after = measureConserved(simulation);
  EXPECT_EQ(after.mass, before.mass);
  // Round-off of 50 steps over some hundred particles; a missing or doubled pair would give 1e-5.
  // Both sides of a pair are summed in float where they are mixed: 6e-8 of the impulses, which are
  // some hundredths of m c together and err at random.
  const double unit = before.mass * settings.soundSpeed;
  const double roundOff = settings.precision == "double" ? 1e-13 : 1e-8;
  double largest = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    largest = std::max(largest, std::abs(after.momentum[a] - before.momentum[a]) / unit);
    // A periodic box has no centre: angular momentum is conserved in an open one only.
    if (!periodic)
      largest =
          std::max(largest, std::abs(after.angularMomentum[a] - before.angularMomentum[a]) / unit);
  }
  EXPECT_LE(largest, roundOff);
  return largest;
}

TYPED_TEST(ConservationTest, MomentumAndAngularMomentumToRoundOff) {
  for (const char* precision : bothPrecisions) {
    SCOPED_TRACE(precision);
    double largest = 0;
    for (const char* density : {"summation", "continuity"})
      for (const bool viscous : {false, true})
        for (const bool colliding : {false, true})
          for (const bool periodic : {false, true})
            largest = std::max(largest,
                               expectConserved<TypeParam::value>(
                                   settingsWith(precision, density, viscous, colliding), periodic));
    std::cout << "  " << precision << ": largest change " << largest << " m c\n";
  }
}

TYPED_TEST(ConservationTest, EveryKernelConservesMomentum) {
  for (const char* precision : bothPrecisions) {
    double largest = 0;
    for (const std::string& name : KernelId::names()) {
      SCOPED_TRACE(name + ", " + precision);
      SolverSettings settings = settingsWith(precision, "summation", true, false);
      settings.kernel = name;
      largest = std::max(largest, expectConserved<TypeParam::value>(settings, false));
    }
    std::cout << "  " << precision << ": largest change " << largest << " m c\n";
  }
}

/// Largest deviation of the total energy of an inviscid gas from its start, relative to the kinetic
/// energy at the start, with steps of `courant` h/c.
template <int Dim>
double energyDeviation(const std::string& precision, double courant) {
  SolverSettings settings;
  settings.precision = precision;
  Simulation<Dim> simulation(test::jitteredScene<Dim>(perAxis(Dim), true, 0.1, 0.5), settings);
  const double dt = courant * simulation.smoothingLength() / settings.soundSpeed;
  simulation.step(1e-12);  // densities that belong to the positions
  const Conserved start = measureConserved(simulation);
  double deviation = 0;
  while (simulation.time() < 0.1) {
    simulation.step(dt);
    deviation =
        std::max(deviation, std::abs(measureConserved(simulation).energy() - start.energy()));
  }
  return deviation / start.kineticEnergy;
}

TYPED_TEST(ConservationTest, EnergyOfAnInviscidGasDeviatesWithTheTimeStepOnly) {
  // Symplectic Euler is of first order: a fifth of the step, a fifth of the deviation.
  for (const char* precision : bothPrecisions) {
    SCOPED_TRACE(precision);
    const double coarse = energyDeviation<TypeParam::value>(precision, 0.1);
    const double fine = energyDeviation<TypeParam::value>(precision, 0.02);
    EXPECT_LT(fine, 0.3 * coarse);
    EXPECT_LT(coarse, 0.2);
  }
}

TYPED_TEST(ConservationTest, StatesHaveTheSameBitsForAnyNumberOfThreads) {
  constexpr int Dim = TypeParam::value;
  for (const char* precision : bothPrecisions) {
    SCOPED_TRACE(precision);
    const auto states = test::forThreads([&] {
      Simulation<Dim> simulation(test::jitteredScene<Dim>(perAxis(Dim), true),
                                 settingsWith(precision, "summation", true, true));
      for (int k = 0; k < 30; ++k) simulation.step(simulation.maxTimeStep());
      std::vector<Vec<Dim>> state;
      for (const std::size_t k : test::byId(simulation.particles())) {
        state.push_back(simulation.particles()[field::position][k]);
        state.push_back(simulation.particles()[field::velocity][k]);
      }
      return state;
    });
    const std::size_t bytes = states[0].size() * sizeof(Vec<Dim>);
    EXPECT_EQ(std::memcmp(states[0].data(), states[1].data(), bytes), 0);
    EXPECT_EQ(std::memcmp(states[0].data(), states[2].data(), bytes), 0);
  }
}

TEST(Threads, ManyParticlesAndAllMeasuresHaveTheSameBits) {
  // Enough for every parallel loop to be parallel: more than worthThreads and several blocks.
  for (const char* precision : bothPrecisions) {
    SCOPED_TRACE(precision);
    const auto rows = test::forThreads([&] {
      Simulation<2> simulation(test::jitteredScene<2>(150, true, 0.2, 1.0),
                               settingsWith(precision, "continuity", true, true));
      for (int k = 0; k < 8; ++k) simulation.step(simulation.maxTimeStep());
      return measureState(simulation);
    });
    for (std::size_t k = 0; k < rows[0].size(); ++k) {
      EXPECT_EQ(rows[0][k].value, rows[1][k].value) << rows[0][k].name;
      EXPECT_EQ(rows[0][k].value, rows[2][k].value) << rows[0][k].name;
    }
  }
}

TYPED_TEST(ConservationTest, OrderOfTheParticlesInTheFileDoesNotMatter) {
  constexpr int Dim = TypeParam::value;
  for (const char* precision : bothPrecisions) {
    const auto settings = settingsWith(precision, "summation", true, false);
    auto scene = test::jitteredScene<Dim>(perAxis(Dim), true);
    auto shuffled = scene;
    std::vector<std::uint32_t> order(scene.particles.size());
    for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
    std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
    test::permute(shuffled.particles, order);
    Simulation<Dim> a(std::move(scene), settings), b(std::move(shuffled), settings);
    for (int k = 0; k < 10; ++k) {
      a.step(1e-4);
      b.step(1e-4);
    }
    const auto ia = test::byId(a.particles()), ib = test::byId(b.particles());
    double largest = 0;
    for (std::size_t k = 0; k < ia.size(); ++k)
      largest = std::max(largest, norm(a.particles()[field::velocity][ia[k]] -
                                       b.particles()[field::velocity][ib[k]]));
    // Sums in another order, and positions relative to other clusters: round-off.
    const double roundOff = settings.precision == "double" ? 1e-12 : 1e-6;
    EXPECT_LE(largest, roundOff) << precision;
    std::cout << "  " << precision << ": largest difference of velocities " << largest << " m/s\n";
  }
}

}  // namespace
}  // namespace plenum
