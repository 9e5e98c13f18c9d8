// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/lattice_modes.hpp"

#include "particles/errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plenum::study {
namespace {

/// The discrete equations themselves, on a periodic box of n cells an axis: accelerations of the
/// particles at `x` by direct sums over all images within the support.
template <int Dim>
std::vector<Vec<Dim>> accelerations(const std::vector<Vec<Dim>>& x, const Vec<Dim>& box,
                                    double mass, const LatticeState& state) {
  const kernel::Any profile{state.kernel};
  const double h = state.smoothingLength, sigma = profile.sigma(Dim);
  const auto forPairs = [&](std::size_t i, auto&& visit) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      Vec<Dim> r = x[i] - x[j];
      for (int a = 0; a < Dim; ++a) r[a] -= box[a] * std::round(r[a] / box[a]);
      if (norm(r) < 2 * h) visit(j, r, norm(r));
    }
  };
  std::vector<double> P(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    double density = 0;
    forPairs(i, [&](std::size_t, const Vec<Dim>&, double r) {
      density += mass * sigma * std::pow(h, -Dim) * profile.f(r / h);
    });
    P[i] = (state.backgroundPressure + density - 1) / (density * density);
  }
  std::vector<Vec<Dim>> a(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    forPairs(i, [&](std::size_t j, const Vec<Dim>& r, double distance) {
      if (j != i)
        a[i] +=
            -mass * (P[i] + P[j]) * sigma * std::pow(h, -(Dim + 2)) * profile.g(distance / h) * r;
    });
  return a;
}

/// Displaces a box of n cells by the lowest wave at a wave vector of the box, and compares what the
/// equations do with -omega^2 times the displacement. Per unit of displacement, which is 1e-5 of a
/// spacing: the rest is of second order in that.
template <int Dim>
void expectModeIsOfTheEquations(const LatticeState& state, int n, const std::array<int, 3>& waves) {
  const LatticeModes<Dim> modes(state);
  Vec<Dim> box{}, k{};
  for (int a = 0; a < Dim; ++a) {
    box[a] = n * modes.edges()[a];
    k[a] = 2 * kernel::pi * waves[static_cast<std::size_t>(a)] / box[a];
    ASSERT_GE(box[a], 4 * state.smoothingLength);
  }
  const Mode<Dim> mode = modes.modeAt(k);
  std::vector<Vec<Dim>> x, xi;
  const int nz = Dim > 2 ? n : 1;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int l = 0; l < nz; ++l)
        for (std::size_t s = 0; s < modes.sites().size(); ++s) {
          Vec<Dim> place = modes.sites()[s];
          const std::array cell{i, j, l};
          for (int a = 0; a < Dim; ++a)
            place[a] += modes.edges()[a] * cell[static_cast<std::size_t>(a)];
          const double phase = dot(k, place);
          x.push_back(place);
          xi.push_back(std::cos(phase) * mode.cosine[s] - std::sin(phase) * mode.sine[s]);
        }
  const double amplitude = 1e-5;
  const double mass =
      box[0] * box[1] * (Dim > 2 ? box[Dim - 1] : 1) / static_cast<double>(x.size());
  std::vector<Vec<Dim>> plus = x, minus = x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    plus[i] += amplitude * xi[i];
    minus[i] += -amplitude * xi[i];
  }
  const auto up = accelerations<Dim>(plus, box, mass, state);
  const auto down = accelerations<Dim>(minus, box, mass, state);
  double largest = 0;
  for (const Vec<Dim>& one : xi) largest = std::max(largest, norm(one));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec<Dim> measured = (1 / (2 * amplitude)) * (up[i] - down[i]);
    EXPECT_LT(norm(measured + mode.omegaSquared * xi[i]), 2e-5 * largest) << i;
  }
}

LatticeState stateOf(const char* lattice, const char* kernel, double h, double p0 = 1) {
  return {lattice, KernelId::named(kernel), h, p0};
}

TEST(LatticeModes, AreThoseOfTheEquationsIn2D) {
  for (const char* kernel :
       {"cubic_spline", "wendland_c2", "wendland_c2_1d", "quintic_spline", "convex"})
    for (const char* lattice : {"square", "hexagonal"}) {
      expectModeIsOfTheEquations<2>(stateOf(lattice, kernel, 1.3), 8, {3, 1, 0});
      expectModeIsOfTheEquations<2>(stateOf(lattice, kernel, 1.8, 0.1), 8, {4, 4, 0});
    }
}

TEST(LatticeModes, AreThoseOfTheEquationsIn3D) {
  for (const char* lattice : {"cubic", "bcc", "fcc", "hcp"})
    expectModeIsOfTheEquations<3>(stateOf(lattice, "wendland_c2", 1.2), 5, {1, 2, 0});
}

/// Long waves are sound: omega = c k, whatever the background pressure, up to the lattice's bias of
/// density, the largest of which is 1.8 % here, and (k h)^2.
TEST(LatticeModes, AreSoundWhereWavesAreLong) {
  for (const double p0 : {0.0, 1.0}) {
    const LatticeModes<2> modes(stateOf("hexagonal", "wendland_c2", 2, p0));
    const double k = 0.01;
    const auto squares = modes.omegaSquared({k, 0});
    // Longitudinal waves are the largest of the lowest branches; the others of a cell of two sites
    // have short waves.
    double nearest = 1;
    for (const double square : squares) nearest = std::min(nearest, std::abs(square / (k * k) - 1));
    EXPECT_LT(nearest, 0.02) << p0;
  }
}

TEST(LatticeModes, NameTheirWave) {
  // Sound along x of a square lattice, where transverse waves are the lower ones.
  const Mode<2> mode = LatticeModes<2>(stateOf("square", "wendland_c2", 2)).modeAt({0.5, 0});
  EXPECT_NEAR(mode.k[0], 0.5, 1e-12);
  EXPECT_NEAR(mode.longitudinal, 0, 1e-9);
  EXPECT_NEAR(mode.wavelength(), 4 * kernel::pi, 1e-9);
}

/// Pairing: the cubic spline at 2 d_ref has a wave that grows, longer than two spacings; tension
/// makes any kernel unstable.
TEST(LatticeModes, GrowWhereParticlesPair) {
  EXPECT_LT(LatticeModes<2>(stateOf("hexagonal", "cubic_spline", 2)).lowest().omegaSquared, -1e-3);
  EXPECT_GT(LatticeModes<2>(stateOf("hexagonal", "wendland_c2", 1.3)).lowest().omegaSquared, -1e-9);
  EXPECT_LT(LatticeModes<2>(stateOf("hexagonal", "wendland_c2", 1.3, -0.5)).lowest().omegaSquared,
            -0.1);
}

/// Corners of the zone of fcc, bcc and hcp are k = 0 of the rectangular cell.
TEST(LatticeModes, OfTheCornersOfTheZoneAreFound) {
  for (const auto& [lattice, kernel, h] : {std::tuple{"hcp", "quartic_liu", 1.5},
                                           {"hcp", "wendland_c2_1d", 1.4},
                                           {"bcc", "wendland_c2_1d", 1.5}}) {
    const LatticeModes<3> modes(stateOf(lattice, kernel, h));
    const double atCorner = modes.omegaSquared({0, 0, 0}).front();
    ASSERT_LT(atCorner, -0.01) << lattice;  // a wave that grows, and no shift
    EXPECT_LE(modes.lowest().omegaSquared, atCorner + 1e-9) << lattice;
  }
}

/// A cell of one site has nothing but shifts at k = 0.
TEST(LatticeModes, AreNoShifts) {
  const Mode<2> mode = LatticeModes<2>(stateOf("square", "wendland_c2", 2)).lowest();
  EXPECT_GT(norm(mode.k), 0.01);
  EXPECT_LT(mode.omegaSquared, 10);
}

TEST(LatticeModes, RefuseLatticesOfOtherDimensions) {
  EXPECT_THROW(LatticeModes<2>(stateOf("fcc", "convex", 1.5)), InputError);
  EXPECT_THROW(LatticeModes<3>(stateOf("hexagonal", "convex", 1.5)), InputError);
}

}  // namespace
}  // namespace plenum::study
