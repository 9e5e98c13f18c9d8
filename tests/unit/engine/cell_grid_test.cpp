// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/cell_grid.hpp"

#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>

#include <set>

namespace plenum {
namespace {

template <class T>
class CellGridTest : public testing::Test {};

using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(CellGridTest, Dimensions);

/// The ranges around a point hold every point within the radius, and none of them twice.
template <int Dim>
void expectComplete(const Box<Dim>& box, double radius, std::size_t maxCells) {
  const auto particles = test::randomParticles<Dim>(box.grown(0.2), 400, 0);
  std::vector<Vec<Dim>> points;
  for (const auto& x : particles[field::position]) points.push_back(box.wrap(x));
  CellGrid<Dim> grid;
  grid.reshape(box, radius, maxCells);
  grid.sort(points);
  for (const Vec<Dim>& x : points) {
    std::multiset<std::uint32_t> found;
    grid.forEachRange(x, [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t place = first; place < last; ++place) found.insert(grid.order()[place]);
    });
    for (std::uint32_t j = 0; j < points.size(); ++j) {
      EXPECT_LE(found.count(j), 1u);
      if (normSquared(box.nearestImage(points[j] - x)) < radius * radius) {
        EXPECT_EQ(found.count(j), 1u);
      }
    }
  }
}

TYPED_TEST(CellGridTest, FindsEveryNeighbourOnce) {
  constexpr int Dim = TypeParam::value;
  for (const bool periodic : {false, true})
    for (const double radius : {0.5, 0.4, 0.3, 0.21, 0.1})  // 2, 2, 3, 4 and 10 cells an axis
      expectComplete<Dim>(test::unitBox<Dim>(periodic), radius, 100000);
}

TYPED_TEST(CellGridTest, StaysCompleteWhenCellsAreRationed) {
  constexpr int Dim = TypeParam::value;
  for (const bool periodic : {false, true})
    expectComplete<Dim>(test::unitBox<Dim>(periodic), 0.05, 30);
}

TYPED_TEST(CellGridTest, TakesNoPointsAndOnePoint) {
  constexpr int Dim = TypeParam::value;
  CellGrid<Dim> grid;
  std::vector<Vec<Dim>> points;
  Box<Dim> flat;  // lower == upper
  grid.reshape(flat, 0.1, 10);
  grid.sort(points);
  std::size_t nFound = 0;
  const auto count = [&](std::uint32_t first, std::uint32_t last) { nFound += last - first; };
  grid.forEachRange(Vec<Dim>{}, count);
  EXPECT_EQ(nFound, 0u);
  points.push_back({});
  grid.sort(points);
  grid.forEachRange(Vec<Dim>{}, count);
  EXPECT_EQ(nFound, 1u);
}

}  // namespace
}  // namespace plenum
