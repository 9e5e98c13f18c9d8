// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/container_map.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

/// Samples of an affine function in counts: interpolation must give it back.
template <int Dim>
ContainerMap<Dim> affineMap() {
  ContainerMap<Dim> map;
  map.lower = Vec<Dim>::filled(-1);
  map.spacing = 0.25;
  map.step = 0.01;
  std::size_t cells = 1;
  for (std::size_t a = 0; a < Dim; ++a) {
    map.shape[a] = 8 + static_cast<int>(a);
    cells *= static_cast<std::size_t>(map.shape[a]);
  }
  for (std::size_t k = 0; k < cells; ++k) {
    int count = -10;
    std::size_t rest = k;
    for (std::size_t a = 0; a < Dim; ++a) {
      const auto n = static_cast<std::size_t>(map.shape[a]);
      count += static_cast<int>((a + 2) * (rest % n));
      rest /= n;
    }
    map.counts.push_back(static_cast<std::int8_t>(count));
  }
  return map;
}

template <int Dim>
double affine(const Vec<Dim>& x) {
  double count = -10;
  for (int a = 0; a < Dim; ++a) count += (a + 2) * ((x[a] + 1) / 0.25 - 0.5);
  return 0.01 * count;
}

template <int Dim>
void expectInterpolation() {
  const ContainerMap<Dim> map = affineMap<Dim>();
  for (double s = -0.87; s < 0.87; s += 0.031) {
    Vec<Dim> x;
    for (int a = 0; a < Dim; ++a) x[a] = (a == 1 ? -s : s);
    // Eight products of numbers below one, summed: a few units of rounding.
    EXPECT_NEAR(map.signedDistance(x), affine(x), 1e-14) << s;
  }
}

TEST(ContainerMap, IsLinearBetweenSamples) {
  expectInterpolation<1>();
  expectInterpolation<2>();
  expectInterpolation<3>();
}

TEST(ContainerMap, IsConstantInTheOuterHalfCells) {
  const ContainerMap<2> map = affineMap<2>();
  EXPECT_EQ(map.signedDistance({{-0.99, -0.875}}), map.signedDistance({{-0.875, -0.875}}));
}

TEST(ContainerMap, BeyondTheGridIsOutside) {
  const ContainerMap<2> map = affineMap<2>();
  EXPECT_EQ(map.signedDistance({{-2, 0}}), 127 * 0.01);
  EXPECT_EQ(map.signedDistance({{0, 99}}), 127 * 0.01);
  EXPECT_EQ(map.signedDistance({{NAN, 0}}), 127 * 0.01);
}

TEST(ContainerMap, EmptyMapIsInsideEverywhere) {
  ContainerMap<3> map;
  map.step = 0.5;
  EXPECT_TRUE(map.empty());
  EXPECT_LT(map.signedDistance({{1e9, 0, 0}}), 0);
}

TEST(ContainerMap, OneCell) {
  ContainerMap<1> map{{{0}}, 1, 0.1, {1}, {-5}};
  EXPECT_EQ(map.signedDistance({{0.2}}), -0.5);
  EXPECT_EQ(map.bounds().upper[0], 1);
}

}  // namespace
}  // namespace plenum
