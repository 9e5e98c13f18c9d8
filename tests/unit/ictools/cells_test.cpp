// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/cells.hpp"

#include "geometry/analytic.hpp"
#include "geometry/round_shapes.hpp"
#include "ictools/hilbert.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

namespace plenum {
namespace {

/// Cells of a grid with 2^level of them an axis, in the order of their keys.
template <int Dim>
std::vector<std::array<std::uint64_t, Dim>> gridAlongCurve(int level) {
  std::vector<std::pair<std::uint64_t, std::array<std::uint64_t, Dim>>> cells;
  const std::uint64_t n = std::uint64_t{1} << level;
  const std::uint64_t total = std::uint64_t{1} << (Dim * level);
  for (std::uint64_t k = 0; k < total; ++k) {
    std::array<std::uint64_t, Dim> x, corner;
    for (std::size_t a = 0; a < Dim; ++a) {
      x[a] = k >> (a * static_cast<std::size_t>(level)) & (n - 1);
      corner[a] = x[a] << (hilbertBits<Dim> - level);
    }
    cells.emplace_back(hilbertKey<Dim>(corner), x);
  }
  std::sort(cells.begin(), cells.end());
  std::vector<std::array<std::uint64_t, Dim>> row;
  for (const auto& [key, x] : cells) row.push_back(x);
  return row;
}

template <int Dim>
void expectUnitSteps(int level) {
  const auto row = gridAlongCurve<Dim>(level);
  for (std::size_t k = 1; k < row.size(); ++k) {
    std::uint64_t steps = 0;
    for (std::size_t a = 0; a < Dim; ++a)
      steps += std::max(row[k][a], row[k - 1][a]) - std::min(row[k][a], row[k - 1][a]);
    ASSERT_EQ(steps, 1u) << k;
  }
}

TEST(Hilbert, CellsThatFollowEachOtherShareAFace) {
  expectUnitSteps<1>(5);
  expectUnitSteps<2>(5);
  expectUnitSteps<3>(4);
}

/// Edges that grow from .02 at x = 0.
template <int Dim>
CellSizes<Dim> growing() {
  return {0.13, [](std::span<const Vec<Dim>> x, std::span<double> edge) {
            for (std::size_t k = 0; k < x.size(); ++k) edge[k] = 0.02 + 0.2 * std::abs(x[k][0]);
          }};
}

TEST(Cells, FillABox) {
  const Box<2> box{{{-0.4, 0}}, {{1, 0.3}}, {}};
  const Cells<2> cells = cellsOf<2>(nullptr, box, growing<2>(), 0);
  EXPECT_NEAR(std::accumulate(cells.volumes.begin(), cells.volumes.end(), 0.0), 1.4 * 0.3, 1e-12);
  EXPECT_FALSE(cells.isSampled);
  for (std::size_t k = 0; k < cells.centers.size(); ++k) {
    const double allowed = std::min(0.13, 0.02 + 0.2 * std::abs(cells.centers[k][0]));
    EXPECT_LE(std::sqrt(cells.volumes[k]), allowed * (1 + 1e-9));
    EXPECT_GE(std::sqrt(cells.volumes[k]), allowed / 3);  // halves, and a box cut into whole cells
  }
}

TEST(Cells, StayInARegion) {
  const auto ball = makeGeometry(Ball<3>{{{0.1, 0.2, 0.3}}, 0.5});
  const Cells<3> cells = cellsOf<3>(ball.get(), ball->bounds(), growing<3>(), 1e-9);
  for (const Vec<3>& x : cells.centers) EXPECT_TRUE(ball->isInside(x));
  const double volume = 4 * std::numbers::pi / 3 * 0.125;
  // A cell is in or out as a whole; up to a quarter of the radius wide, they leave 1.2 %.
  EXPECT_NEAR(std::accumulate(cells.volumes.begin(), cells.volumes.end(), 0.0), volume,
              0.02 * volume);
}

TEST(Cells, SamplesStandForAll) {
  const Box<3> box{{{0, 0, 0}}, {{1, 1, 1}}, {}};
  CellSizes<3> sizes = growing<3>();
  sizes.most = 1000;
  const Cells<3> cells = cellsOf<3>(nullptr, box, sizes, 0);
  EXPECT_TRUE(cells.isSampled);
  // Drawn again at each of two levels, a thousand each: three percent, three times.
  EXPECT_NEAR(std::accumulate(cells.volumes.begin(), cells.volumes.end(), 0.0), 1, 0.1);
}

}  // namespace
}  // namespace plenum
