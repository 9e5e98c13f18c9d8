// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/lattice.hpp"

#include "ictools/fill.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace plenum {
namespace {

struct Expected {
  std::string name;
  int neighbours;
  double cellVolume;  // in d_ref^d
};

/// The table at the top of lattice.hpp.
template <int Dim>
std::vector<Expected> expectedLattices() {
  if (Dim == 1) return {{"uniform", 2, 1}};
  if (Dim == 2) return {{"square", 4, 1}, {"hexagonal", 6, std::sqrt(3.0) / 2}};
  return {{"cubic", 6, 1},
          {"bcc", 8, 4 / (3 * std::sqrt(3.0))},
          {"fcc", 12, 1 / std::sqrt(2.0)},
          {"hcp", 12, 1 / std::sqrt(2.0)}};
}

template <class T>
class LatticeTest : public testing::Test {};
TYPED_TEST_SUITE(LatticeTest, test::Dimensions);

TYPED_TEST(LatticeTest, NeighboursStandAtTheSpacing) {
  constexpr int Dim = TypeParam::value;
  const double d = 0.3;
  for (const Expected& expected : expectedLattices<Dim>()) {
    const Lattice<Dim> lattice(expected.name, d);
    const Box<Dim> box{Vec<Dim>::filled(-2.2 * d), Vec<Dim>::filled(2.2 * d), {}};
    int n = 0;
    double nearest = 1e9;
    for (const Vec<Dim>& x : latticePoints(lattice, box)) {
      const double r = norm(x);  // a lattice point stands at zero
      if (r > 1e-9) nearest = std::min(nearest, r);
      if (r > 1e-9 && r < 1.01 * d) ++n;
    }
    EXPECT_EQ(n, expected.neighbours) << expected.name;
    EXPECT_NEAR(nearest, d, 1e-14 * d * 10) << expected.name;  // coordinates are of order d
  }
}

TYPED_TEST(LatticeTest, CellVolumeIsExactAndCounted) {
  constexpr int Dim = TypeParam::value;
  const double length = 40;
  for (const Expected& expected : expectedLattices<Dim>()) {
    const Lattice<Dim> lattice(expected.name, 1);
    EXPECT_NEAR(lattice.cellVolume(), expected.cellVolume, 1e-15) << expected.name;
    const Box<Dim> box{Vec<Dim>::filled(0.123), Vec<Dim>::filled(0.123 + length), {}};
    const auto n = static_cast<double>(latticePoints(lattice, box).size());
    // At each end up to one row, of spacing at most 1.64 (hcp along z), is counted too much.
    EXPECT_NEAR(n * expected.cellVolume / box.volume(), 1, Dim * 1.64 / length) << expected.name;
  }
}

TYPED_TEST(LatticeTest, FitsPeriodsWithoutSeam) {
  constexpr int Dim = TypeParam::value;
  Box<Dim> box{Vec<Dim>::filled(-0.4), {}, {}};
  const double lengths[] = {1.0, 1.37, 0.91};
  for (int a = 0; a < Dim; ++a) box.upper[a] = box.lower[a] + lengths[a];
  box.periodic.fill(true);
  for (const Expected& expected : expectedLattices<Dim>()) {
    for (const bool startsAtFace : {true, false}) {
      Lattice<Dim> lattice(expected.name, 0.1);
      lattice.fitTo(box);
      if (startsAtFace)
        lattice.placeAt(box.lower);  // points lie on the periodic face itself
      else
        lattice.startAt(box.lower);
      const auto points = latticePoints(lattice, box);
      // Whole cells fill the box: the number times the cell is its volume.
      EXPECT_NEAR(static_cast<double>(points.size()) * lattice.cellVolume() / box.volume(), 1,
                  1e-12);
      double worst = 1;
      for (int a = 0; a < Dim; ++a) {
        worst = std::max(worst, std::abs(1 + lattice.deviation(a)));
        worst = std::max(worst, 1 / std::abs(1 + lattice.deviation(a)));
        EXPECT_GE(points.front()[a], box.lower[a]);
        EXPECT_LT(points.back()[a], box.upper[a]);
      }
      // Everybody's nearest neighbour is at d_ref, stretched by no more than the axes are.
      for (const double r : test::nearestDistances(points, box)) {
        EXPECT_GE(r, 0.1 / worst * (1 - 1e-12)) << expected.name;
        EXPECT_LE(r, 0.1 * worst * (1 + 1e-12)) << expected.name;
      }
    }
  }
}

TEST(Lattice, HexagonalPeriodsThatFitAreLeftAlone) {
  Box<2> box{{{0, 0}}, {{1, 12 * std::sqrt(3.0) * 0.05}}, {true, true}};
  Lattice<2> lattice("hexagonal", 0.05);
  lattice.fitTo(box);
  EXPECT_NEAR(lattice.deviation(0), 0, 1e-15 * 20);  // 20 cells: round-off of the division
  EXPECT_NEAR(lattice.deviation(1), 0, 1e-15 * 20);
}

TEST(Lattice, ReportsHowFarItIsStretched) {
  // 0.05 sqrt(3) = 0.0866025 goes 11.547 times into 1: 12 periods.
  Box<2> box{{{0, 0}}, {{1, 1}}, {true, true}};
  Lattice<2> lattice("hexagonal", 0.05);
  lattice.fitTo(box);
  EXPECT_NEAR(lattice.deviation(1), 1.0 / 12 / (0.05 * std::sqrt(3.0)) - 1, 1e-14);
}

TEST(Lattice, StartsHalfARowFromTheWall) {
  const double d = 0.1;
  const Box<2> box{{{2, -1}}, {{3, 0}}, {}};
  Lattice<2> hexagonal("hexagonal", d);
  hexagonal.startAt(box.lower);
  const auto points = latticePoints(hexagonal, box);
  // Round-off of coordinates of order 1.
  EXPECT_NEAR(points[0][0], 2 + d / 4, 1e-15 * 4);
  EXPECT_NEAR(points[0][1], -1 + std::sqrt(3.0) / 4 * d, 1e-15 * 4);
  EXPECT_NEAR(points[10][0], 2 + 3 * d / 4, 1e-15 * 4);
  EXPECT_NEAR(points[10][1], -1 + 3 * std::sqrt(3.0) / 4 * d, 1e-15 * 4);
  for (const char* name : {"hcp", "fcc", "bcc", "cubic"}) {
    Lattice<3> lattice(name, d);
    lattice.startAt({{0, 0, 0}});
    Box<3> cell{{}, 5.0 * lattice.edges(), {}};
    const auto all = latticePoints(lattice, cell);
    for (int a = 0; a < 3; ++a) {  // as far from the upper walls as from the lower ones
      double lowest = 1e9, highest = -1e9;
      for (const Vec<3>& x : all) {
        lowest = std::min(lowest, x[a]);
        highest = std::max(highest, x[a]);
      }
      EXPECT_NEAR(lowest, cell.upper[a] - highest, 1e-14) << name << a;
    }
  }
}

TEST(Lattice, ABoxDoesNotChangeTheBits) {
  const Lattice<3> lattice("hcp", 0.1);
  const Box<3> large{Vec<3>::filled(-1), Vec<3>::filled(1), {}};
  const Box<3> small{Vec<3>::filled(-0.31), Vec<3>::filled(0.47), {}};
  const auto all = latticePoints(lattice, large);
  for (const Vec<3>& x : latticePoints(lattice, small))
    EXPECT_NE(std::find(all.begin(), all.end(), x), all.end());
}

}  // namespace
}  // namespace plenum
