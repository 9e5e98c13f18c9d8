// SPDX-License-Identifier: GPL-3.0-or-later
//
// Particles smoothed over pixels: masses, lattices, periods, means.
#include "particles/picture_map.hpp"

#include "tests/support/threads.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum {
namespace {

template <int Dim>
Box<Dim> periodicUnitBox() {
  Box<Dim> box;
  for (int a = 0; a < Dim; ++a) {
    box.lower[a] = 0;
    box.upper[a] = 1;
    box.periodic[a] = true;
  }
  return box;
}

template <int Dim>
MapKernel<Dim> kernelOf(double h) {
  return {KernelId::named("wendland_c2"), h, periodicUnitBox<Dim>()};
}

template <int Dim>
ParticleSet<Dim> setOf(const std::vector<Vec<Dim>>& positions, double mass) {
  ParticleSet<Dim> set({field::position, field::mass, field::density}, positions.size(), 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    set[field::position][i] = positions[i];
    set[field::mass][i] = mass;
    set[field::density][i] = 1;
  }
  return set;
}

ParticleSet<3> cubicLattice(int n) {
  std::vector<Vec<3>> positions;
  for (int k = 0; k < n * n * n; ++k)
    positions.push_back({{(k % n + 0.5) / n, (k / n % n + 0.5) / n, (k / n / n + 0.5) / n}});
  return setOf<3>(positions, 1.0 / (n * n * n));
}

MapPlane<3> fromTheFront(int width) { return {{0, 1, 0, 1}, width, 0, 2}; }

double massOf(const PixelMap& map) {
  double sum = 0;
  for (double value : map.values) sum += std::isnan(value) ? 0 : value;
  return sum / (map.width * map.height);  // of the unit square
}

TEST(PictureMap, ColumnsHoldTheMassOfTheirParticles) {
  for (double h : {1e-4, 0.004, 0.03, 0.2})
    for (double x : {0.5, 0.31234, 0.999}) {
      const auto set = setOf<3>({{{x, 0.2, 0.77}}}, 2.5);
      const PixelMap map = densityMap(set, fromTheFront(100), kernelOf<3>(h));
      // To rounding; wide kernels are not normalized, their sums over pixels are right to 1e-4.
      EXPECT_NEAR(massOf(map), 2.5, h < 0.06 ? 1e-12 : 2.5e-4) << h << ' ' << x;
    }
}

TEST(PictureMap, AnEvenSetHasTheColumnOfItsDepth) {
  const PixelMap map = densityMap(cubicLattice(12), fromTheFront(60), kernelOf<3>(0.15));
  for (double value : map.values)
    EXPECT_NEAR(value, 1, 0.005);  // h = 1.8 spacings: a lattice of columns is even to .3 %
}

TEST(PictureMap, ACutShowsTheDensity) {
  MapPlane<3> plane = fromTheFront(60);
  for (double cut : {0.0, 0.04, 0.5, 0.98}) {
    plane.cut = cut;
    const PixelMap map = densityMap(cubicLattice(12), plane, kernelOf<3>(0.15));
    for (double value : map.values) EXPECT_NEAR(value, 1, 0.01);  // the lattice's bias is .1 %
  }
}

TEST(PictureMap, WhatLeavesAtOneSideEntersAtTheOther) {
  const PixelMap inside =
      densityMap(setOf<3>({{{0.5, 0.1, 0.5}}}, 1), fromTheFront(40), kernelOf<3>(0.1));
  const PixelMap corner =
      densityMap(setOf<3>({{{0, 0.1, 0}}}, 1), fromTheFront(40), kernelOf<3>(0.1));
  const auto at = [](const PixelMap& map, int column, int row) {
    const double value = map.at(column % 40, row % 40);
    return std::isnan(value) ? 0 : value;
  };
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 40; ++column)
      EXPECT_NEAR(at(corner, column, row), at(inside, column + 20, row + 20), 1e-10);
}

TEST(PictureMap, MeansOfALinearFieldAreLinear) {
  const ParticleSet<3> set = cubicLattice(16);
  std::vector<double> numbers;
  for (const Vec<3>& x : set[field::position]) numbers.push_back(3 * x[0] - x[2]);
  MapPlane<3> plane = fromTheFront(32);
  for (const bool isCut : {false, true}) {
    if (isCut) plane.cut = 0.4;
    const PixelMap map = meanMap(set, numbers, plane, kernelOf<3>(0.1));
    for (int row = 8; row < 24; ++row)  // away from the faces, where the field jumps
      for (int column = 8; column < 24; ++column)
        EXPECT_NEAR(map.at(column, row), 3 * (column + 0.5) / 32 - (row + 0.5) / 32, 0.02);
  }
}

TEST(PictureMap, PlanesOfTwoDimensions) {
  std::vector<Vec<2>> positions;
  for (int k = 0; k < 400; ++k) positions.push_back({{(k % 20 + 0.5) / 20, (k / 20 + 0.5) / 20}});
  const MapPlane<2> plane{{0, 1, 0, 0.5}, 50};
  const PixelMap map = densityMap(setOf<2>(positions, 1.0 / 400), plane, kernelOf<2>(0.1));
  EXPECT_EQ(map.height, 25);
  for (double value : map.values) EXPECT_NEAR(value, 1, 0.01);  // the lattice's bias at h = 2
}

TEST(PictureMap, NothingReachesHere) {
  MapPlane<3> plane = fromTheFront(20);
  plane.cut = 0.8;
  for (double value : densityMap(setOf<3>({{{0.5, 0.5, 0.5}}}, 1), plane, kernelOf<3>(0.1)).values)
    EXPECT_TRUE(std::isnan(value));
}

TEST(PictureMap, SameBitsForAnyNumberOfThreads) {
  const ParticleSet<3> set = cubicLattice(10);
  const auto maps =
      test::forThreads([&] { return densityMap(set, fromTheFront(80), kernelOf<3>(0.12)).values; });
  EXPECT_EQ(maps[0], maps[1]);
  EXPECT_EQ(maps[0], maps[2]);
}

}  // namespace
}  // namespace plenum
