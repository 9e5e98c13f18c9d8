// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/fill.hpp"

#include "geometry/round_shapes.hpp"
#include "ictools/point_grid.hpp"
#include "ictools/random.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <numbers>

namespace plenum {
namespace {

const auto disk = makeGeometry(Ball<2>{{{0, 0}}, 0.1});
const auto annulus = makeGeometry(Annulus{{{0, 0}}, 0.04, 0.1});

Box<2> around(double r) { return {Vec<2>::filled(-r), Vec<2>::filled(r), {}}; }

TEST(Fill, MarchingFindsWhatEveryPointFinds) {
  Lattice<2> lattice("hexagonal", 0.005);
  for (const DistanceBand band : {DistanceBand{.upper = -1e-9}, DistanceBand{-0.012, 0.003},
                                  DistanceBand{0.001, 0.04}, DistanceBand{-0.0301, -0.02}}) {
    std::vector<Vec<2>> expected;
    for (const Vec<2>& x : latticePoints(lattice, around(0.16))) {
      const double distance = annulus->signedDistance(x);
      if (distance >= band.lower && distance <= band.upper) expected.push_back(x);
    }
    EXPECT_GT(expected.size(), 50u);
    EXPECT_EQ(latticePoints(lattice, around(0.16), *annulus, band), expected);
  }
}

TEST(Fill, ThreadsDoNotChangeAnything) {
  const Lattice<2> lattice("hexagonal", 0.001);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = latticePoints(lattice, around(0.16), *annulus, {.upper = 0});
  omp_set_num_threads(2);
  const auto two = latticePoints(lattice, around(0.16), *annulus, {.upper = 0});
  omp_set_num_threads(before);
  EXPECT_EQ(one, two);
}

/// Counts its queries.
class Counting final : public Geometry<2> {
 public:
  void signedDistance(std::span<const Vec<2>> points, std::span<double> result) const override {
#pragma omp atomic
    n += points.size();
    disk->signedDistance(points, result);
  }
  void closest(std::span<const Vec<2>> points, std::span<SurfacePoint<2>> result) const override {
    disk->closest(points, result);
  }
  Box<2> bounds() const override { return disk->bounds(); }
  Measure volume() const override { return disk->volume(); }
  std::string describe() const override { return "counting"; }
  mutable std::size_t n = 0;
};

TEST(Fill, QueriesGrowWithTheSurfaceOnly) {
  const Counting geometry;
  const Lattice<2> lattice("square", 1e-4);
  const auto points = latticePoints(lattice, around(0.1), geometry, {.upper = 0});
  EXPECT_NEAR(static_cast<double>(points.size()), std::numbers::pi * 1e6, 1e4);
  EXPECT_LT(geometry.n, points.size() / 20);  // 2000 rows, some steps to each of two ends
}

/// [C] (Kruisbrink et al. 2018, doi 10.4236/jamp.2018.69158), section 5: strictly inside
/// .04 < r < .1.
TEST(Fill, RotatingShaft) {
  const Lattice<2> lattice("hexagonal", 0.005);
  const double roundOff = surfaceRoundOff * 0.005;
  EXPECT_EQ(latticePoints(lattice, around(0.1), *annulus, {.upper = -roundOff}).size(), 1212u);
  const Scene<2> scene = test::sceneOf<2>(test::shaftCase());
  EXPECT_EQ(scene.particles.nFluid(), 1212u);
  EXPECT_EQ(scene.particles.nWalls(), 871u);
}

TEST(Fill, FailuresOfAGeometryReachTheCaller) {
  class Broken final : public Geometry<2> {
   public:
    void signedDistance(std::span<const Vec<2>>, std::span<double>) const override {
      throw InputError("broken");
    }
    void closest(std::span<const Vec<2>>, std::span<SurfacePoint<2>>) const override {}
    Box<2> bounds() const override { return around(1); }
    Measure volume() const override { return {}; }
    std::string describe() const override { return "broken"; }
  };
  EXPECT_THROW(latticePoints(Lattice<2>("square", 0.01), around(1), Broken(), {}), InputError);
}

TEST(Random, IsTheSameEverywhere) {
  // std::mt19937_64 is fixed by the standard, [rand.predef]: the 10000th number of the default seed
  // is 9981545732273789042.
  std::mt19937_64 reference;
  reference.discard(9999);
  EXPECT_EQ(reference(), 9981545732273789042u);
  Random random(std::mt19937_64::default_seed);
  for (int k = 0; k < 9999; ++k) random.number();
  EXPECT_EQ(random.number(), static_cast<double>(9981545732273789042u >> 11) / 9007199254740992.0);
}

TEST(PointGrid, PointsThatAreNowhereHaveNobodyNear) {
  const Box<2> box = around(1);
  PointGrid<2> grid(box, 0.1, 1);
  grid.insert({{0.99, 0.99}});
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), 1e300, -1e300,
                         std::numeric_limits<double>::infinity()})
    EXPECT_EQ(grid.nearest({{x, 0.99}}), std::numeric_limits<double>::infinity());
}

TEST(PointGrid, FindsTheNearestInEveryKindOfBox) {
  Random random(7);
  for (const bool periodic : {false, true})
    for (const double reach : {0.05, 0.2, 0.45}) {  // many cells, few, two an axis
      Box<3> box{Vec<3>::filled(-0.5), Vec<3>::filled(0.5), {}};
      box.periodic = {periodic, false, periodic};
      std::vector<Vec<3>> points;
      for (int k = 0; k < 300; ++k) points.push_back(random.pointIn(box));
      const PointGrid<3> grid(box, reach, points);
      const auto expected = test::nearestDistances(points, box);
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (expected[k] <= reach)
          EXPECT_EQ(grid.nearest(points[k], k), expected[k]);
        else
          EXPECT_EQ(grid.nearest(points[k], k), std::numeric_limits<double>::infinity());
      }
    }
}

}  // namespace
}  // namespace plenum
