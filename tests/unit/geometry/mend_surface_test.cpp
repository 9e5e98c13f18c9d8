// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mend_surface.hpp"
#include "files_for_tests.hpp"
#include "geometry/surface_check.hpp"
#include "geometry/surface_mesh.hpp"

#include <gtest/gtest.h>

namespace plenum::test {
namespace {

/// A cube with two triangles a side, 8 corners.
TriangleSoup cube(double lower = 0, double upper = 1) {
  TriangleSoup soup;
  for (int k = 0; k < 8; ++k)
    soup.points.push_back({{k & 1 ? upper : lower, k & 2 ? upper : lower, k & 4 ? upper : lower}});
  soup.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
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

struct Mended {
  TriangleSoup soup;
  std::vector<Finding> said;
};

Mended mend(const TriangleSoup& soup, const MendOptions& options = {}) {
  Mended result;
  result.soup =
      mended(soup, options, "test.stl", [&](const Finding& f) { result.said.push_back(f); });
  return result;
}

/// The mended soup is sound and has this volume; one thing was said, with these words.
void expectMended(const Mended& mended, double volume, const std::vector<std::string>& words) {
  EXPECT_TRUE(surfaceFaults(mended.soup, "test.stl").empty());
  EXPECT_NEAR(signedVolume(mended.soup), volume, 1e-12);  // round-off of sums of size 1
  ASSERT_EQ(mended.said.size(), 1u);
  EXPECT_EQ(mended.said[0].severity, Severity::note);
  EXPECT_FALSE(mended.said[0].remedy.empty());
  for (const std::string& word : words)
    EXPECT_NE(mended.said[0].what.find(word), std::string::npos) << mended.said[0].what;
}

TEST(MendSurface, SoundSurfacesStayAsTheyAre) {
  const TriangleSoup soup = welded(cube());
  const Mended same = mend(soup);
  EXPECT_EQ(same.soup.triangles, soup.triangles);
  EXPECT_EQ(same.soup.points, soup.points);
  EXPECT_TRUE(same.said.empty());
}

TEST(MendSurface, CornersThatRepeatAreJoinedWithAWordUnlessTheFormatRepeatsThem) {
  TriangleSoup repeated = cube();
  repeated.points.push_back(repeated.points[7]);
  repeated.triangles[2][2] = 8;
  expectMended(mend(repeated), 1, {"1 corner was joined", "(1, 1, 1)"});
  TriangleSoup stl;
  for (const auto& t : cube().triangles) {
    const std::size_t n = stl.points.size();
    for (std::size_t k : t) stl.points.push_back(cube().points[k]);
    stl.triangles.push_back({n, n + 1, n + 2});
  }
  EXPECT_TRUE(mend(stl).said.empty());
  stl.points[0][0] += 1e-12;  // near, not the same
  expectMended(mend(stl), 1, {"corner"});
}

TEST(MendSurface, TurnsASurfaceThatIsInsideOut) {
  expectMended(mend(inverted(cube())), 1, {"1 part was inside out"});
  expectMended(mend(both(cube(), inverted(cube(2, 3)))), 2, {"1 part was inside out", "(2."});
  const TriangleSoup hollow = both(cube(), inverted(cube(0.25, 0.75)));
  EXPECT_TRUE(mend(hollow).said.empty());
  expectMended(mend(inverted(hollow)), 1 - 0.125, {"1 part"});  // turned with its cavity
}

TEST(MendSurface, TurnsTheFewerTriangles) {
  TriangleSoup soup = cube();
  std::swap(soup.triangles[4][0], soup.triangles[4][1]);
  std::swap(soup.triangles[7][0], soup.triangles[7][1]);
  expectMended(mend(soup), 1, {"2 triangles were turned"});
}

TEST(MendSurface, DoesNotGuessWhetherAPartInsideAnotherIsACavity) {
  const Mended left = mend(both(cube(), cube(0.25, 0.75)));
  EXPECT_TRUE(left.said.empty());
  const auto faults = surfaceFaults(left.soup, "test.stl");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].what.find("inside another"), std::string::npos);
}

// Corner 8 in the middle of edge 0-1: a sliver without area joins its two sides there.
TEST(MendSurface, TakesOutTrianglesWithoutArea) {
  TriangleSoup soup = cube();
  soup.points.push_back({{0.5, 0, 0}});
  soup.triangles[1] = {8, 0, 3};  // of the bottom: 0-3-1 in two
  soup.triangles.push_back({8, 3, 1});
  soup.triangles.push_back({0, 8, 1});  // its long side is that of the front's 0-1-5
  ASSERT_EQ(surfaceFaults(soup, "test.stl").size(), 1u);
  const Mended mended = mend(soup);
  expectMended(mended, 1, {"1 triangle was taken out", "(0.5, 0, 0)"});
  EXPECT_EQ(mended.soup.triangles.size(), 14u);  // the front has three triangles now
}

TEST(MendSurface, LeavesOutWhatHangsOnAnEdge) {
  TriangleSoup soup = cube();
  soup.points.push_back({{0.5, 0, 0}});
  soup.triangles.push_back({0, 8, 1});
  expectMended(mend(soup), 1, {"1 triangle was taken out"});
}

TEST(MendSurface, ClosesSmallHolesOnRequestOnly) {
  TriangleSoup soup = cube();
  soup.triangles.erase(soup.triangles.begin() + 2, soup.triangles.begin() + 4);  // the lid
  const auto faults = surfaceFaults(soup, "test.stl");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].what.find("4 such edges"), std::string::npos);
  EXPECT_NE(faults[0].what.find("1 hole, 1.414 m across, at (0.5, 0.5, 1)"), std::string::npos);
  EXPECT_NE(faults[0].remedy.find("mend = { holes = true }"), std::string::npos);
  EXPECT_EQ(mend(soup).soup.triangles.size(), 10u);
  // The hole's diagonal is sqrt(2), the cube's sqrt(3): 0.816.
  EXPECT_EQ(mend(soup, {true, 0.81}).soup.triangles.size(), 10u);
  expectMended(mend(soup, {true, 0.82}), 1, {"closed 1 hole", "(0.5, 0.5, 1)"});
  soup.triangles.push_back({4, 5, 7});
  expectMended(mend(soup, {true, 0.82}), 1, {"closed 1 hole"});  // one triangle
}

TEST(MendSurface, EdgesWithManyTrianglesAreLeftForTheCheck) {
  TriangleSoup beside = cube();
  for (Vec<3>& x : beside.points) x += Vec<3>{{1, 1, 0}};  // they share the edge x = y = 1
  const auto faults = surfaceFaults(mend(both(cube(), beside), {true, 0.5}).soup, "test.stl");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].what.find("more than two triangles): 1 such edge, the first at (1, 1, 0.5)"),
            std::string::npos)
      << faults[0].what;
  EXPECT_NE(faults[0].remedy.find("touch along an edge"), std::string::npos);
}

TEST(MendSurface, AllFaultsAreFoundAtOnce) {
  TriangleSoup soup = cube();
  soup.points.push_back({{0.5, 0, 0}});
  soup.triangles.push_back({0, 8, 1});
  std::swap(soup.triangles[10][0], soup.triangles[10][1]);
  const auto faults = surfaceFaults(soup, "test.stl");  // flat, open, crowded, turned
  EXPECT_EQ(faults.size(), 4u);
  for (const Finding& fault : faults) EXPECT_EQ(fault.place.size(), 3u);
  expectError([&] { makeSurfaceMesh(soup, "test.stl"); }, {"no area", "3 more errors"});
}

TEST(MendSurface, NamesTheCornerThatIsNoNumber) {
  TriangleSoup soup = cube();
  soup.points[5][1] = std::nan("");
  expectError([&] { checkFinite(soup, "test.ply"); }, {"test.ply", "number 5 of triangle 2"});
}

}  // namespace
}  // namespace plenum::test
