// SPDX-License-Identifier: GPL-3.0-or-later
//
// Water at rest on a hexagonal lattice: with continuity (5.23), the product form (5.24) and masses
// m_i = rho_i V, the first force has a closed form. The pressure is linear in height, its constant
// part cancels by symmetry, and what is left is the lattice moment M = -sum_j V y_j^2 F_j.
#include "particles/kernels.hpp"
#include "solver/simulation.hpp"
#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace plenum {
namespace {

constexpr double d = 0.01, rowHeight = 0.8660254037844386 * d, cell = d * rowHeight;
constexpr double rho0 = 1000, g = 9.81, c = 30, waterHeight = 40 * rowHeight;
constexpr int nColumns = 12, nFluidRows = 40, nWallRows = 6;

double densityAt(double y) { return rho0 + rho0 * g * (waterHeight - y) / (c * c); }

/// Rows of a hexagonal lattice, periodic along x; those below y = 0 are the wall.
Scene<2> column() {
  Scene<2> scene;
  scene.info.spacing = d;
  scene.info.domain.lower = {{0, -nWallRows * rowHeight}};
  scene.info.domain.upper = {{nColumns * d, waterHeight}};
  scene.info.domain.periodic = {true, false};
  scene.info.materials = {{"water", rho0}};
  scene.info.walls = {{"floor", "lattice", nWallRows, nWallRows * rowHeight, rho0, {}}};
  scene.particles =
      test::randomParticles<2>(scene.info.domain, nFluidRows * nColumns, nWallRows * nColumns);
  ParticleSet<2>& p = scene.particles;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const bool isFluid = k < p.nFluid();
    const auto n = static_cast<int>(isFluid ? k : k - p.nFluid());
    const int row = isFluid ? n / nColumns : -1 - n / nColumns;
    const double y = (row + 0.5) * rowHeight;
    p[field::position][k] = {{(n % nColumns + 0.25 + 0.5 * std::abs(row % 2)) * d, y}};
    p[field::velocity][k] = {};
    p[field::density][k] = densityAt(y);
    p[field::mass][k] = densityAt(y) * cell;
  }
  for (auto& normal : p[field::normal]) normal = {{0, 1}};
  return scene;
}

template <class Profile>
double latticeMoment(double h) {
  double sum = 0;
  for (int j = -10; j <= 10; ++j)
    for (int i = -10; i <= 10; ++i) {
      const double x = (i + 0.5 * std::abs(j % 2)) * d, y = j * rowHeight;
      if (i != 0 || j != 0) sum -= cell * y * y * Kernel<2, Profile>::F(std::hypot(x, y), h);
    }
  return sum;
}

void expectLatticeMoment(const std::string& precision, double tolerance) {
  SolverSettings settings;
  settings.kernel = "wendland_c2_1d";
  settings.density = "continuity";
  settings.wallPressure = "equation_of_state";
  settings.soundSpeed = c;
  settings.gravity = {0, -g};
  settings.smoothingLength = 1.5;
  settings.precision = precision;
  const double moment = latticeMoment<kernel::WendlandC2OneD>(1.5 * d);
  EXPECT_NEAR(moment - 1, -0.00761, 1e-5);  // docs/validation.md: -.761 %, to the digits given

  Simulation<2> simulation(column(), settings);
  simulation.step(1e-9);
  const auto& particles = simulation.particles();
  auto accelerations = simulation.engine().sums(field::force);
  for (std::size_t i = 0; i < accelerations.size(); ++i)
    accelerations[i] *= 1 / particles[field::mass][i];
  int nChecked = 0;
  double worst = 0;
  for (std::size_t i = 0; i < particles.nFluid(); ++i) {
    const double y = particles[field::position][i][1];
    if (y > waterHeight - 3.1 * d) continue;  // the free surface lacks neighbours
    const double expected = g * rho0 / densityAt(y) * moment;
    EXPECT_NEAR(accelerations[i][1], expected, tolerance);
    EXPECT_NEAR(accelerations[i][0], 0, tolerance);
    worst =
        std::max({worst, std::abs(accelerations[i][1] - expected), std::abs(accelerations[i][0])});
    ++nChecked;
  }
  EXPECT_EQ(nChecked, 36 * nColumns);
  std::cout << "  " << precision << ": largest deviation " << worst << " m/s^2\n";
}

// Sums of some 30 terms of p/rho^2 dW of up to 1e3 m/s^2 that cancel: 1e-12 of them, and 5e-7 where
// pairs are in float (1e-4 m/s^2 was seen).
TEST(Hydrostatic, TheFirstForceIsTheLatticeMomentOfTheKernel) {
  expectLatticeMoment("double", 1e-8);
  expectLatticeMoment("mixed", 5e-4);
}

}  // namespace
}  // namespace plenum
