// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks a geometry against nothing but a membership test.
#pragma once

#include "geometry/geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace plenum::test {

template <int Dim>
class Random {
 public:
  explicit Random(unsigned seed = 1) : engine_(seed) {}

  double number(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(engine_);
  }

  Vec<Dim> inBox(const Box<Dim>& box) {
    Vec<Dim> x;
    for (int a = 0; a < Dim; ++a) x[a] = number(box.lower[a], box.upper[a]);
    return x;
  }

  Vec<Dim> direction() {
    while (true) {
      const Vec<Dim> d = inBox({Vec<Dim>::filled(-1), Vec<Dim>::filled(1), {}});
      if (const double r = norm(d); r > 0.1 && r <= 1) return d / r;
    }
  }

 private:
  std::mt19937 engine_;
};

template <int Dim>
using Member = std::function<bool(const Vec<Dim>&)>;

/// Both sides are met within `step` [m] of p; many tries, since wedges may be narrow.
template <int Dim>
bool isOnSurface(const Member<Dim>& member, const Vec<Dim>& p, double step, Random<Dim>& random) {
  bool in = false;
  bool out = false;
  for (int k = 0; k < 20000 && !(in && out); ++k)
    (member(p + step * random.direction()) ? in : out) = true;
  return in && out;
}

/// At `n` random points of `box`: sign, distance, nearest point, normal and the batched calls agree
/// with `member`. The distance is right if the nearest point lies on the surface and no sampled
/// point that is nearer lies on the other side. `size` [m] is the scale of round-off.
template <int Dim>
void expectTrueDistances(const Geometry<Dim>& geometry, const Member<Dim>& member,
                         const Box<Dim>& box, int n, double size = 1) {
  Random<Dim> random(7);
  const double roundOff = 1e-9 * size;  // set operations judge coincidence at 1e-10 of the size
  std::vector<Vec<Dim>> points;
  for (int k = 0; k < n; ++k) points.push_back(random.inBox(box));
  std::vector<SurfacePoint<Dim>> hits(points.size());
  std::vector<double> distances(points.size());
  std::vector<std::uint8_t> inside(points.size());
  geometry.closest(points, hits);
  geometry.signedDistance(points, distances);
  geometry.inside(points, inside);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec<Dim>& x = points[k];
    const SurfacePoint<Dim>& hit = hits[k];
    SCOPED_TRACE(testing::Message()
                 << geometry.describe() << " at " << testing::PrintToString(x.components) << " -> "
                 << testing::PrintToString(hit.point.components));
    const double distance = std::abs(hit.signedDistance);
    ASSERT_NEAR(hit.signedDistance, distances[k], roundOff);
    ASSERT_EQ(inside[k] != 0, distances[k] < 0);
    if (distance > roundOff) {
      ASSERT_EQ(hit.signedDistance < 0, member(x));
    }
    ASSERT_NEAR(norm(hit.normal), 1, 1e-12);
    ASSERT_NEAR(norm(x - hit.point - hit.signedDistance * hit.normal), 0, roundOff);
    ASSERT_TRUE(isOnSurface(member, hit.point, 1e-6 * size, random));
    for (int j = 0; j < 100; ++j) {
      const double r = distance * (1 - 1e-6) * std::pow(random.number(0, 1), 0.2);
      const Vec<Dim> y = x + r * random.direction();
      ASSERT_EQ(member(x), member(y)) << "nearer: " << testing::PrintToString(y.components);
    }
    if (member(x)) {
      ASSERT_TRUE(geometry.bounds().grown(roundOff).contains(x));
    }
  }
}

/// |gradient| of the signed distance = 1 along the normal, by central differences; not at the few
/// points near which the nearest surface changes.
template <int Dim>
void expectUnitGradient(const Geometry<Dim>& geometry, const Box<Dim>& box, int n) {
  Random<Dim> random(3);
  const double step = 1e-6;
  int kinks = 0;
  for (int k = 0; k < n; ++k) {
    const Vec<Dim> x = random.inBox(box);
    const SurfacePoint<Dim> hit = geometry.closest(x);
    const double slope = (geometry.signedDistance(x + step * hit.normal) -
                          geometry.signedDistance(x - step * hit.normal)) /
                         (2 * step);
    if (std::abs(slope - 1) > 1e-6) ++kinks;  // rounding 1e-16 / step, curvature cancels
  }
  EXPECT_LE(kinks, n / 200);
}

}  // namespace plenum::test
