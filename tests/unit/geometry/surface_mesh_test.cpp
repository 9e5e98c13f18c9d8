// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_mesh.hpp"
#include "files_for_tests.hpp"
#include "geometry/box_shape.hpp"
#include "probe.hpp"

#include <numbers>
#include <thread>

namespace plenum::test {
namespace {

/// The prism over a polygon that the fan of its first corner fills; z from 0 to `height`.
TriangleSoup prism(const std::vector<Vec<2>>& base, double height) {
  TriangleSoup soup;
  const std::size_t n = base.size();
  for (const double z : {0., height})
    for (const Vec<2>& x : base) soup.points.push_back({{x[0], x[1], z}});
  for (std::size_t k = 2; k < n; ++k) {
    soup.triangles.push_back({0, k, k - 1});
    soup.triangles.push_back({n, n + k - 1, n + k});
  }
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    soup.triangles.push_back({k, next, n + next});
    soup.triangles.push_back({k, n + next, n + k});
  }
  return soup;
}

TriangleSoup cube(double lower = 0, double upper = 1) {
  TriangleSoup soup = prism({{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}, 1);
  for (Vec<3>& x : soup.points) x = Vec<3>::filled(lower) + (upper - lower) * x;
  return soup;
}

TriangleSoup inverted(TriangleSoup soup) {
  for (auto& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

TriangleSoup both(TriangleSoup a, const TriangleSoup& b) {
  const std::size_t n = a.points.size();
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return a;
}

const Box<3> surroundings{{{-1, -1, -1}}, {{2, 2, 2}}, {}};

TEST(SurfaceMesh, CubeAgreesWithTheBox) {
  const auto mesh = makeSurfaceMesh(cube(), "cube");
  const auto box = makeGeometry(BoxShape<3>{{{{0, 0, 0}}, {{1, 1, 1}}, {}}});
  Random<3> random;
  for (int k = 0; k < 5000; ++k) {
    const Vec<3> x = random.inBox(surroundings);
    const SurfacePoint<3> hit = mesh->closest(x);
    const SurfacePoint<3> exact = box->closest(x);
    EXPECT_NEAR(hit.signedDistance, exact.signedDistance, 1e-14);  // round-off at size 1
    if (std::abs(exact.signedDistance) >
        1e-6) {  // where two faces are equally near either is right
      EXPECT_NEAR(norm(x - hit.point - hit.signedDistance * hit.normal), 0, 1e-14);
    }
  }
  EXPECT_DOUBLE_EQ(mesh->volume().value, 1);
  EXPECT_EQ(mesh->volume().error, 0);
}

// Sharp convex and reflex edges and corners, where the nearest triangle alone says the wrong side.
TEST(SurfaceMesh, SharpEdgesHaveTheRightSign) {
  const std::vector<Vec<2>> arrow = {{{0, 0.5}}, {{-0.8, -0.9}}, {{1.8, 0.5}}, {{-0.8, 1.9}}};
  const auto mesh = makeSurfaceMesh(prism(arrow, 1), "arrow");
  const auto member = [&](const Vec<3>& x) {
    bool in = false;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec<2>& a = arrow[k];
      const Vec<2>& b = arrow[(k + 1) % 4];
      if ((a[1] > x[1]) != (b[1] > x[1]) &&
          x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        in = !in;
    }
    return in && x[2] > 0 && x[2] < 1;
  };
  expectTrueDistances<3>(*mesh, member, {{{-2, -2, -1}}, {{3, 3, 2}}, {}}, 3000);
  expectUnitGradient<3>(*mesh, {{{-2, -2, -1}}, {{3, 3, 2}}, {}}, 2000);
}

TEST(SurfaceMesh, CavitiesAreOutside) {
  const auto mesh = makeSurfaceMesh(both(cube(), inverted(cube(0.25, 0.75))), "hollow");
  EXPECT_DOUBLE_EQ(mesh->volume().value, 1 - 0.125);
  EXPECT_FALSE(mesh->isInside({{0.5, 0.5, 0.5}}));
  EXPECT_DOUBLE_EQ(mesh->signedDistance({{0.5, 0.5, 0.3}}), 0.05);
  EXPECT_TRUE(mesh->isInside({{0.1, 0.5, 0.5}}));
}

TEST(SurfaceMesh, OnTheSurfaceNothingIsWrong) {
  const auto mesh = makeSurfaceMesh(cube(), "cube");
  for (const Vec<3>& x : {Vec<3>{{0, 0, 0}}, {{1, 0.5, 0.5}}, {{1, 1, 0.25}}, {{0.5, 0.5, 0}}}) {
    EXPECT_EQ(mesh->signedDistance(x), 0);
    EXPECT_NEAR(norm(mesh->closest(x).normal), 1, 1e-15);
  }
}

TEST(SurfaceMesh, RefusesOpenSurfacesAndSaysWhere) {
  TriangleSoup open = cube();
  open.triangles.pop_back();
  expectError([&] { makeSurfaceMesh(open, "open.stl"); },
              {"open.stl", "not closed", "3 such edges", "(0, 0", "close the holes"});
}

TEST(SurfaceMesh, RefusesWhatIsInsideOut) {
  expectError([&] { makeSurfaceMesh(inverted(cube()), "in.stl"); },
              {"in.stl", "inside out", "flip its normals"});
  expectError([&] { makeSurfaceMesh(both(cube(), inverted(cube(3, 4))), "two.stl"); },
              {"of one part is inside out", "(3."});
  expectError([&] { makeSurfaceMesh(both(cube(), cube(0.25, 0.75)), "two.stl"); },
              {"inside another", "cavity"});
  TriangleSoup mixed = cube();
  std::swap(mixed.triangles[0][0], mixed.triangles[0][1]);
  expectError([&] { makeSurfaceMesh(mixed, "mixed.stl"); },
              {"turned against each other", "3 such edges", "coherently"});
}

TEST(SurfaceMesh, RefusesSelfIntersections) {
  expectError([&] { makeSurfaceMesh(both(cube(), cube(0.5, 1.5)), "x.stl"); },
              {"x.stl", "crosses itself", "near (", "union"});
}

TEST(SurfaceMesh, RefusesDegenerateTriangles) {
  TriangleSoup soup = cube();  // an edge with a corner in its middle: a triangle without area
  soup.points.push_back({{0.5, 0, 0}});
  const std::size_t a = 0, b = 1, middle = soup.points.size() - 1;
  soup.triangles.push_back({a, middle, b});
  expectError([&] { makeSurfaceMesh(soup, "flat.stl"); },
              {"1 triangle has no area", "(0.5, 0, 0)", "degenerate"});
  expectError([&] { makeSurfaceMesh({}, "none.stl"); }, {"none.stl", "no triangles"});
  TriangleSoup doubled = both(cube(), cube());
  expectError([&] { makeSurfaceMesh(doubled, "twice.stl"); }, {"more than two triangles"});
}

TEST(SurfaceMesh, RefusesSurfacesThatTouchThemselvesInAPoint) {
  TriangleSoup other = cube(1, 2);
  expectError([&] { makeSurfaceMesh(both(cube(), other), "touch.stl"); },
              {"touches itself in a point"});
}

TEST(SurfaceMesh, WeldsWhatFilesRepeat) {
  const TriangleSoup connected = cube();
  TriangleSoup apart;
  for (std::size_t t = 0; t < connected.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k)
      apart.points.push_back(connected.corner(t, k) + Vec<3>::filled(1e-12 * double(k)));
    apart.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  EXPECT_EQ(welded(apart).points.size(), 8u);
  EXPECT_NEAR(makeSurfaceMesh(apart, "apart")->volume().value, 1, 1e-11);  // moved by 1e-12
}

TEST(SurfaceMesh, TurnsMeshesOfCadOutwards) {
  TriangleSoup soup = both(cube(), cube(0.25, 0.75));
  for (std::size_t t = 0; t < soup.triangles.size(); t += 2)
    std::swap(soup.triangles[t][0], soup.triangles[t][1]);
  EXPECT_DOUBLE_EQ(makeSurfaceMesh(turnedOutwards(soup), "cad")->volume().value, 1 - 0.125);
}

TEST(SurfaceMesh, TwoThreadsSeeTheSame) {
  const auto mesh = makeSurfaceMesh(cube(), "cube");
  Random<3> random;
  std::vector<Vec<3>> points(20000);
  for (Vec<3>& x : points) x = random.inBox(surroundings);
  for (std::size_t k = 0; k < points.size(); k += 10) points[k][0] = 1;  // on faces: exact rays
  std::vector<double> alone(points.size()), first(points.size()), second(points.size());
  std::thread one([&] { mesh->signedDistance(points, first); });
  std::thread two([&] { mesh->signedDistance(points, second); });
  one.join();
  two.join();
  mesh->signedDistance(points, alone);
  EXPECT_EQ(alone, first);
  EXPECT_EQ(alone, second);
}

}  // namespace
}  // namespace plenum::test
