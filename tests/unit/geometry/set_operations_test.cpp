// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/box_shape.hpp"
#include "geometry/extrusion.hpp"
#include "geometry/placement.hpp"
#include "geometry/polygon.hpp"
#include "geometry/round_shapes.hpp"
#include "geometry/set_operation.hpp"
#include "particles/errors.hpp"
#include "probe.hpp"

#include <thread>

namespace plenum::test {
namespace {

template <int Dim>
Box<Dim> around(double half) {
  return {Vec<Dim>::filled(-half), Vec<Dim>::filled(half), {}};
}

GeometryPtr<2> disk(double x, double y, double r) { return makeGeometry(Ball<2>{{{x, y}}, r}); }
GeometryPtr<3> ball(double x, double y, double z, double r) {
  return makeGeometry(Ball<3>{{{x, y, z}}, r});
}
template <int Dim>
GeometryPtr<Dim> box(const Vec<Dim>& lower, const Vec<Dim>& upper) {
  return makeGeometry(BoxShape<Dim>{{lower, upper, {}}});
}

template <int Dim>
Member<Dim> allOf(std::vector<GeometryPtr<Dim>> parts) {
  return [parts](const Vec<Dim>& x) {
    return std::ranges::all_of(parts, [&](const auto& part) { return part->isInside(x); });
  };
}
template <int Dim>
Member<Dim> anyOf(std::vector<GeometryPtr<Dim>> parts) {
  return [parts](const Vec<Dim>& x) {
    return std::ranges::any_of(parts, [&](const auto& part) { return part->isInside(x); });
  };
}
template <int Dim>
Member<Dim> firstOnly(std::vector<GeometryPtr<Dim>> parts) {
  return [parts](const Vec<Dim>& x) {
    bool in = parts[0]->isInside(x);
    for (std::size_t k = 1; k < parts.size(); ++k) in = in && !parts[k]->isInside(x);
    return in;
  };
}

template <int Dim>
void expectOperations(const std::vector<GeometryPtr<Dim>>& parts, double half, int n) {
  expectTrueDistances(*unionOf(parts), anyOf(parts), around<Dim>(half), n);
  expectTrueDistances(*intersectionOf(parts), allOf(parts), around<Dim>(half), n);
  expectTrueDistances(*differenceOf(parts), firstOnly(parts), around<Dim>(half), n);
}

TEST(SetOperations, OverlappingIntervals) {
  expectOperations<1>({box<1>({{-1}}, {{0.5}}), box<1>({{-0.25}}, {{1}})}, 2, 500);
}

TEST(SetOperations, DiskAndBoxMeetInCorners) {
  expectOperations<2>({disk(0, 0, 1), box<2>({{0.2, -0.3}}, {{2, 0.6}})}, 2, 1000);
}

TEST(SetOperations, LensOfTwoDisks) {
  expectOperations<2>({disk(-0.6, 0, 1), disk(0.6, 0.1, 0.9)}, 2, 1000);
}

TEST(SetOperations, ThreeDisks) {
  expectOperations<2>({disk(-0.4, 0, 1), disk(0.4, 0.1, 0.9), disk(0, -0.5, 0.7)}, 2, 1000);
}

TEST(SetOperations, BallAndBoxMeetInCurves) {
  expectOperations<3>({ball(0, 0, 0, 1), box<3>({{0.2, -0.3, -2}}, {{2, 0.6, 0.4}})}, 1.5, 600);
}

TEST(SetOperations, BallsMeetInCircles) {
  expectOperations<3>({ball(-0.5, 0, 0, 1), ball(0.5, 0.1, 0, 0.9), ball(0, -0.5, 0.2, 0.8)}, 1.5,
                      600);
}

TEST(SetOperations, BoxMinusCylinderThatGoesThrough) {
  const std::vector<GeometryPtr<3>> parts = {
      box<3>({{-0.5, -0.5, 0}}, {{0.5, 0.5, 0.5}}),
      makeGeometry(Cylinder{{{0, 0, -1}}, {{0, 0, 2}}, 0.25})};
  expectTrueDistances(*differenceOf(parts), firstOnly(parts), around<3>(1), 1000);
}

TEST(SetOperations, NestedOperations) {
  const auto plate = differenceOf<2>({box<2>({{-1, -1}}, {{1, 1}}), disk(0, 0, 0.5)});
  const std::vector<GeometryPtr<2>> parts = {plate, box<2>({{-2, -0.25}}, {{0, 0.25}})};
  expectOperations<2>(parts, 2, 500);
}

TEST(SetOperations, CutByAHalfSpace) {
  const std::vector<GeometryPtr<3>> parts = {
      ball(0, 0, 0, 1), makeGeometry(HalfSpace<3>{{{0, 0, 0.3}}, {{0, 0.6, 0.8}}})};
  expectOperations<3>(parts, 1.5, 600);
}

// Where two boxes share a face there is no surface: neither near it nor on it.
TEST(SetOperations, TouchingBoxesAreOneRegion) {
  const auto joined = unionOf<2>({box<2>({{0, 0}}, {{1, 1}}), box<2>({{1, 0}}, {{2, 1}})});
  const Box<2> whole{{{0, 0}}, {{2, 1}}, {}};
  expectTrueDistances<2>(
      *joined, [&](const Vec<2>& x) { return whole.contains(x); },
      {{{-0.5, -0.5}}, {{2.5, 1.5}}, {}}, 1000);
  const SurfacePoint<2> onTheSeam = joined->closest(Vec<2>{{1, 0.6}});
  EXPECT_NEAR(onTheSeam.signedDistance, -0.4, 1e-9);  // coincidence is judged at 1e-10 of the size
  EXPECT_TRUE(joined->isInside(Vec<2>{{1, 0.6}}));

  const auto solid =
      unionOf<3>({box<3>({{0, 0, 0}}, {{1, 1, 1}}), box<3>({{1, 0, 0}}, {{2, 1, 1}})});
  const Box<3> wholeSolid{{{0, 0, 0}}, {{2, 1, 1}}, {}};
  expectTrueDistances<3>(
      *solid, [&](const Vec<3>& x) { return wholeSolid.contains(x); },
      {{{-0.5, -0.5, -0.5}}, {{2.5, 1.5, 1.5}}, {}}, 300);
}

/// A narrow bore through two blocks and their seam, and a pocket that ends at the seam.
TEST(SetOperations, SeamsWithHolesInThem) {
  const Loop square = {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}};
  const Loop bore = {{{0.47, 0.47}}, {{0.53, 0.47}}, {{0.53, 0.53}}, {{0.47, 0.53}}};
  const Loop pocket = {{{0.2, 0.7}}, {{0.3, 0.7}}, {{0.3, 0.8}}, {{0.2, 0.8}}};
  const auto lower = makePolygon({{square, {bore, pocket}}}, "lower");
  const auto upper = makePolygon({{square, {bore}}}, "upper");
  const auto joined = unionOf<3>({extruded(lower, 0, 1), extruded(upper, 1, 2)});
  expectTrueDistances<3>(
      *joined,
      [&](const Vec<3>& x) {
        const Vec<2> below{{x[0], x[1]}};
        return x[2] > 0 && x[2] < 2 && (x[2] < 1 ? lower : upper)->isInside(below);
      },
      {{{0.05, 0.05, 0.9}}, {{0.95, 0.95, 1.1}}, {}}, 100);
}

/// The bound has the sign of the distance, is never larger, and takes an edge for a plane at most.
TEST(SetOperations, BoundsOfDistances) {
  const auto block = box<3>({{-0.5, -0.5, -0.25}}, {{0.5, 0.5, 0.25}});
  const auto bore = makeGeometry(Cylinder{{{0, 0, -1}}, {{0, 0, 1}}, 0.25});
  Placement<3> placement;
  placement.scale = 2;
  placement.rotate(20, {1, 2, 3});
  Random<3> random;
  for (const auto& shape : {differenceOf<3>({block, bore}), unionOf<3>({block, bore}),
                            placed(differenceOf<3>({block, bore}), placement)}) {
    for (int k = 0; k < 1000; ++k) {
      const Vec<3> x = random.inBox(around<3>(1));
      const double exact = shape->signedDistance(x);
      const double bound = shape->distanceBound(x);
      ASSERT_EQ(bound < 0, exact < 0);
      ASSERT_LE(std::abs(bound), std::abs(exact) + 1e-9);  // judged at 1e-10 of the size
    }
  }
  EXPECT_EQ(block->distanceBound(Vec<3>{{1, 1, 0}}), std::hypot(0.5, 0.5));
}

TEST(SetOperations, NotchFlushWithTheTop) {
  const auto notched =
      differenceOf<2>({box<2>({{0, 0}}, {{1, 1}}), box<2>({{0.4, 0.5}}, {{0.6, 1}})});
  const SurfacePoint<2> above = notched->closest(Vec<2>{{0.45, 1.5}});
  EXPECT_NEAR(above.signedDistance, std::hypot(0.05, 0.5), 1e-9);  // the corner, not the old top
  EXPECT_FALSE(notched->isInside(Vec<2>{{0.5, 1}}));
}

template <int Dim>
GeometryPtr<Dim> randomShape(Random<Dim>& random) {
  const Vec<Dim> center = random.inBox(around<Dim>(1));
  const double kind = random.number(0, 1);
  if (kind < 0.4) return makeGeometry(Ball<Dim>{center, random.number(0.3, 1.2)});
  if (kind < 0.8) {
    Vec<Dim> half;
    for (int a = 0; a < Dim; ++a) half[a] = random.number(0.2, 1);
    return box<Dim>(center - half, center + half);
  }
  if constexpr (Dim == 3) {
    if (kind < 0.9)
      return makeGeometry(Cylinder{center, random.inBox(around<3>(1)), random.number(0.2, 0.8)});
  }
  return makeGeometry(HalfSpace<Dim>{center, random.direction()});
}

/// Two to four shapes at random: wedges, slivers, several separate pieces.
template <int Dim>
void expectRandomCombinations(int n, int nPoints) {
  Random<Dim> random(5);
  for (int k = 0; k < n; ++k) {
    std::vector<GeometryPtr<Dim>> parts;
    const int nParts = static_cast<int>(random.number(2, 5));
    for (int p = 0; p < nParts; ++p) parts.push_back(randomShape(random));
    const auto expectTrue = [&](auto operation, const Member<Dim>& member) {
      GeometryPtr<Dim> combined;
      try {
        combined = operation(parts);
      } catch (const InputError&) {
        return;  // empty
      }
      expectTrueDistances(*combined, member, around<Dim>(2), nPoints);
    };
    expectTrue(unionOf<Dim>, anyOf(parts));
    expectTrue(intersectionOf<Dim>, allOf(parts));
    expectTrue(differenceOf<Dim>, firstOnly(parts));
  }
}

TEST(SetOperations, RandomCombinations) {
  expectRandomCombinations<2>(60, 40);
  expectRandomCombinations<3>(15, 40);
}

TEST(SetOperations, EmptyAndFullRegionsAreRefused) {
  EXPECT_THROW(intersectionOf<2>({disk(0, 0, 1), disk(3, 0, 1)}), InputError);
  EXPECT_THROW(differenceOf<2>({disk(0, 0, 1), disk(0, 0, 1)}), InputError);
  EXPECT_THROW(intersectionOf<2>({box<2>({{0, 0}}, {{1, 1}}), box<2>({{1, 0}}, {{2, 1}})}),
               InputError);
  const auto left = makeGeometry(HalfSpace<2>{{}, {{1, 0}}});
  const auto right = makeGeometry(HalfSpace<2>{{}, {{-1, 0}}});
  EXPECT_THROW(unionOf<2>({left, right}), InputError);
}

TEST(SetOperations, ScaleDoesNotMatter) {
  for (const double s : {1e-6, 1e6}) {
    const std::vector<GeometryPtr<2>> parts = {disk(0, 0, s),
                                               box<2>({{0.2 * s, -0.3 * s}}, {{2 * s, 0.6 * s}})};
    expectTrueDistances(*differenceOf(parts), firstOnly(parts), around<2>(2 * s), 300, s);
  }
}

TEST(SetOperations, TwoThreadsSeeTheSame) {
  const auto shape = differenceOf<2>({disk(0, 0, 1), box<2>({{0.2, -0.3}}, {{2, 0.6}})});
  Random<2> random;
  std::vector<Vec<2>> points(2000);
  for (Vec<2>& x : points) x = random.inBox(around<2>(2));
  std::vector<double> alone(points.size());
  shape->signedDistance(points, alone);
  std::vector<double> first(points.size());
  std::vector<double> second(points.size());
  std::thread one([&] { shape->signedDistance(points, first); });
  std::thread two([&] { shape->signedDistance(points, second); });
  one.join();
  two.join();
  EXPECT_EQ(alone, first);
  EXPECT_EQ(alone, second);
}

}  // namespace
}  // namespace plenum::test
