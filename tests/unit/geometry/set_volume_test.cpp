// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/box_shape.hpp"
#include "geometry/round_shapes.hpp"
#include "geometry/set_operation.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace plenum {
namespace {

constexpr double pi = std::numbers::pi;

GeometryPtr<2> disk(double x, double y, double r) { return makeGeometry(Ball<2>{{{x, y}}, r}); }
template <int Dim>
GeometryPtr<Dim> box(const Vec<Dim>& lower, const Vec<Dim>& upper) {
  return makeGeometry(BoxShape<Dim>{{lower, upper, {}}});
}

void expectExact(const Measure& measure, double value) {
  EXPECT_EQ(measure.error, 0);
  EXPECT_NEAR(measure.value, value, 1e-14 * value);  // round-off
}

/// The error that is stated holds, and is small enough to be of use.
void expectWithin(const Measure& measure, double value, double relative) {
  EXPECT_NEAR(measure.value, value, measure.error);
  EXPECT_GT(measure.error, 0);
  EXPECT_LT(measure.error, relative * value);
}

TEST(SetVolume, NestedPartsAreExact) {
  expectExact(differenceOf<2>({disk(0, 0, 0.1), disk(0, 0, 0.04)})->volume(), pi * (0.01 - 0.0016));
  expectExact(unionOf<2>({disk(0, 0, 1), disk(0.2, 0, 0.5)})->volume(), pi);
  expectExact(intersectionOf<2>({disk(0, 0, 1), disk(0.2, 0, 0.5)})->volume(), pi / 4);
  expectExact(differenceOf<3>({box<3>({{0, 0, 0}}, {{1, 1, 1}}),
                               makeGeometry(Ball<3>{{{0.5, 0.5, 0.5}}, 0.25})})
                  ->volume(),
              1 - 4 * pi / 3 / 64);
  // Not concentric: 0.05 apart where they are nearest.
  expectExact(differenceOf<2>({disk(0, 0, 1), disk(0.45, 0, 0.5)})->volume(), 0.75 * pi);
}

TEST(SetVolume, DisjointPartsAreExact) {
  expectExact(unionOf<2>({disk(0, 0, 1), disk(3, 0, 0.5)})->volume(), 1.25 * pi);
  // Their boxes overlap, they do not.
  expectExact(unionOf<2>({disk(0, 0, 1), disk(1.5, 1.5, 1)})->volume(), 2 * pi);
  expectExact(differenceOf<2>({disk(0, 0, 1), disk(1.5, 1.5, 1)})->volume(), pi);
}

TEST(SetVolume, BoxesAreExact) {
  const auto a = box<2>({{0, 0}}, {{2, 1}});
  const auto b = box<2>({{1, 0.5}}, {{3, 2}});
  const auto touching = box<2>({{2, 0}}, {{3, 0.5}});
  expectExact(unionOf<2>({a, b})->volume(), 2 + 3 - 0.5);
  expectExact(intersectionOf<2>({a, b})->volume(), 0.5);
  expectExact(differenceOf<2>({a, b})->volume(), 1.5);
  expectExact(unionOf<2>({a, touching})->volume(), 2.5);
  expectExact(unionOf<2>({a, b, box<2>({{0.5, 0.25}}, {{1.5, 3}})})->volume(),
              4.5 + 2.75 - 0.75 - 0.5 * 1.5 + 0.5 * 0.5);
}

TEST(SetVolume, SeveralHoles) {
  expectExact(differenceOf<2>({box<2>({{0, 0}}, {{4, 2}}), disk(1, 1, 0.5), disk(3, 1, 0.5),
                               disk(3, 1, 0.25), disk(9, 9, 1)})
                  ->volume(),
              8 - pi / 2);
}

TEST(SetVolume, LensOfDisks) {
  const double lens = 2 * (pi / 3 - std::sqrt(3.) / 4);  // radii 1, centres 1 apart
  const std::vector<GeometryPtr<2>> disks = {disk(0, 0, 1), disk(1, 0, 1)};
  // Tens of thousands of cells cross a surface of length ~1: far below 1e-5.
  expectWithin(intersectionOf(disks)->volume(), lens, 1e-5);
  expectWithin(unionOf(disks)->volume(), 2 * pi - lens, 1e-5);
  expectWithin(differenceOf(disks)->volume(), pi - lens, 1e-5);
}

TEST(SetVolume, CylinderThroughABox) {
  const auto part = differenceOf<3>({box<3>({{-0.5, -0.5, 0}}, {{0.5, 0.5, 0.5}}),
                                     makeGeometry(Cylinder{{{0, 0, -1}}, {{0, 0, 2}}, 0.25})});
  // About 100 cells along each edge; tangent planes leave errors of second order.
  expectWithin(part->volume(), 0.5 * (1 - pi / 16), 1e-3);
}

TEST(SetVolume, UnboundedRegionsAreInfinite) {
  const auto half = makeGeometry(HalfSpace<2>{{}, {{0, 1}}});
  EXPECT_TRUE(std::isinf(differenceOf<2>({half, disk(0, 0, 1)})->volume().value));
  // Half a disk.
  expectWithin(intersectionOf<2>({disk(0, 0, 1), half})->volume(), pi / 2, 1e-5);
}

}  // namespace
}  // namespace plenum
