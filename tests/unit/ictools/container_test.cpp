// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/container.hpp"

#include "geometry/box_shape.hpp"
#include "geometry/round_shapes.hpp"
#include "geometry/set_operation.hpp"
#include "ictools/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace plenum {
namespace {

template <int Dim>
SceneFrame<Dim> frameOf(double spacing, const Box<Dim>& domain) {
  return {spacing, domain, {}};
}

const double infinite = std::numeric_limits<double>::infinity();

/// Linear between samples d_ref/2 apart: the error is at most (spacing^2/8) over the radius, plus
/// half a step.
TEST(Container, AgreesWithTheGeometry) {
  const double d = 0.01;
  const auto annulus = makeGeometry(Annulus{{{0.2, 0}}, 0.1, 0.3});
  const Box<2> open{Vec<2>::filled(-infinite), Vec<2>::filled(infinite), {}};
  const auto map = containerMap<2>({annulus}, frameOf<2>(d, open));
  EXPECT_DOUBLE_EQ(map.spacing, d / 2);
  EXPECT_DOUBLE_EQ(map.step, d / 32);
  EXPECT_NEAR(map.bounds().lower[0], -0.1 - 4 * d, 1e-12);
  Random random(5);
  for (int k = 0; k < 20000; ++k) {
    const Vec<2> x = random.pointIn(map.bounds().grown(-d));
    const double exact = annulus->signedDistance(x);
    if (std::abs(exact) > 127 * map.step - d) continue;  // beside samples that are clipped
    const double curvature = (d / 2) * (d / 2) / 4 / 0.06;
    EXPECT_NEAR(map.signedDistance(x), exact, map.step / 2 + curvature + 1e-12);
  }
}

TEST(Container, UniteRegionsInThreeDimensions) {
  const double d = 0.05;
  const auto left = makeGeometry(Ball<3>{{{0, 0, 0}}, 0.3});
  const auto right = makeGeometry(Ball<3>{{{0.4, 0, 0}}, 0.3});
  const Box<3> open{Vec<3>::filled(-infinite), Vec<3>::filled(infinite), {}};
  const auto map = containerMap<3>({left, right}, frameOf<3>(d, open));
  Random random(6);
  for (int k = 0; k < 5000; ++k) {
    const Vec<3> x = random.pointIn(map.bounds());
    const double exact = std::min(left->signedDistance(x), right->signedDistance(x));
    if (std::abs(exact) > d) continue;
    EXPECT_NEAR(map.signedDistance(x), exact, 0.3 * d);  // the crease between the balls is rounded
  }
}

/// Above a bore the nearest point is on its rim: exact at the surface, and of the right sign and
/// not too large further out.
TEST(Container, SetOperations) {
  const double d = 0.05;
  const auto block = makeGeometry(BoxShape<3>{{{{-0.5, -0.5, -0.25}}, {{0.5, 0.5, 0.25}}, {}}});
  const auto bore = makeGeometry(Cylinder{{{0, 0, -1}}, {{0, 0, 1}}, 0.25});
  const auto part = differenceOf<3>({block, bore});
  const Box<3> open{Vec<3>::filled(-infinite), Vec<3>::filled(infinite), {}};
  const auto map = containerMap<3>({part}, frameOf<3>(d, open));
  Random random(7);
  for (int k = 0; k < 3000; ++k) {
    const Vec<3> x = random.pointIn(map.bounds().grown(-d));
    const double exact = part->signedDistance(x);
    const double error = map.signedDistance(x) - exact;
    // Between samples d/2 apart, edges are rounded.
    if (std::abs(exact) < d / 4) {
      EXPECT_NEAR(error, 0, 0.3 * d);
    }
    if (std::abs(exact) < 3 * d) {
      EXPECT_LT(exact > 0 ? error : -error, 0.3 * d);
    }
  }
}

TEST(Container, PeriodicFacesAreNoWalls) {
  const Box<2> domain{{{0, -infinite}}, {{1.03, infinite}}, {true, false}};
  const auto channel = makeGeometry(BoxShape<2>{{{{0, 0}}, {{1.03, 1}}, {}}});
  const auto map = containerMap<2>({channel}, frameOf<2>(0.1, domain));
  for (const double x : {0.0, 0.001, 0.5, 1.0, 1.029})
    for (const double y : {0.1, 0.5, 0.9}) EXPECT_LT(map.signedDistance({{x, y}}), 0) << x << y;
  EXPECT_GT(map.signedDistance({{0.5, 1.1}}), 0.09);
}

TEST(Container, NoRegionMeansEverywhere) {
  EXPECT_TRUE(containerMap<2>({}, frameOf<2>(0.1, {})).empty());
}

}  // namespace
}  // namespace plenum
