// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon.hpp"
#include "files_for_tests.hpp"
#include "geometry/box_shape.hpp"
#include "geometry/geometry_set.hpp"
#include "geometry/set_operation.hpp"
#include "probe.hpp"
#include "tests/support/named_region.hpp"

#include <thread>

namespace plenum::test {
namespace {

const Loop square = {{{0, 0}}, {{4, 0}}, {{4, 4}}, {{0, 4}}};
const Loop hole = {{{1, 1}}, {{3, 1}}, {{3, 3}}, {{1, 3}}};
const Box<2> surroundings{{{-2, -2}}, {{6, 6}}, {}};

/// By crossings of a ray along x.
bool evenOdd(const std::vector<Loop>& loops, const Vec<2>& x) {
  bool in = false;
  for (const Loop& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec<2>& a = loop[k];
      const Vec<2>& b = loop[(k + 1) % loop.size()];
      if ((a[1] > x[1]) != (b[1] > x[1]) &&
          x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        in = !in;
    }
  return in;
}

/// Arms of a star: sharp convex and reflex corners.
Loop star(int arms, double inner, double outer) {
  Loop loop;
  for (int k = 0; k < 2 * arms; ++k) {
    const double r = k % 2 == 0 ? outer : inner;
    loop.push_back(
        {{2 + r * std::cos(3.14159265 * k / arms), 2 + r * std::sin(3.14159265 * k / arms)}});
  }
  return loop;
}

TEST(Polygon, DistancesAreTrue) {
  for (const std::vector<Loop>& loops : {std::vector<Loop>{square},
                                         {square, hole},
                                         {star(7, 0.3, 3)},
                                         {star(9, 2, 3.5), star(5, 0.2, 1)}}) {
    const auto polygon = makePolygon(nestedLoops(loops, "test"), "test");
    expectTrueDistances<2>(
        *polygon, [&](const Vec<2>& x) { return evenOdd(loops, x); }, surroundings, 1000, 4);
    expectUnitGradient<2>(*polygon, surroundings, 1000);
  }
}

TEST(Polygon, AgreesWithBoxes) {
  const auto polygon = makePolygon({{square, {hole}}}, "test");
  const auto boxes = differenceOf<2>({makeGeometry(BoxShape<2>{{{{0, 0}}, {{4, 4}}, {}}}),
                                      makeGeometry(BoxShape<2>{{{{1, 1}}, {{3, 3}}, {}}})});
  Random<2> random;
  for (int k = 0; k < 2000; ++k) {
    const Vec<2> x = random.inBox(surroundings);
    EXPECT_NEAR(polygon->signedDistance(x), boxes->signedDistance(x),
                1e-14);  // round-off at size 4
  }
  EXPECT_DOUBLE_EQ(polygon->volume().value, 12);
  EXPECT_EQ(polygon->volume().error, 0);
  EXPECT_EQ(polygon->bounds().upper, (Vec<2>{{4, 4}}));
}

TEST(Polygon, OnCornersAndEdgesNothingIsWrong) {
  const auto polygon = makePolygon({{square, {hole}}}, "test");
  for (const Vec<2>& x : {Vec<2>{{0, 0}}, {{4, 2}}, {{1, 1}}, {{2, 1}}, {{4, 4}}}) {
    EXPECT_EQ(polygon->signedDistance(x), 0);
    EXPECT_NEAR(norm(polygon->closest(x).normal), 1, 1e-15);
  }
}

TEST(Polygon, CornersInTheMiddleOfAStraightLineHaveTwoSides) {
  const auto polygon =
      makePolygon({{{{{0, 0}}, {{1, 0}}, {{2, 0}}, {{2, 1}}, {{0, 1}}}, {}}}, "test");
  EXPECT_DOUBLE_EQ(polygon->signedDistance({{1, 0.25}}), -0.25);
  EXPECT_DOUBLE_EQ(polygon->signedDistance({{1, -0.25}}), 0.25);
}

TEST(Polygon, EitherWayRoundIsTheSame) {
  Loop turned(square.rbegin(), square.rend());
  EXPECT_DOUBLE_EQ(makePolygon({{turned, {hole}}}, "test")->volume().value, 12);
}

TEST(Polygon, ReadsWellKnownText) {
  const auto ring = writeFile("a.wkt", "Polygon((0 0, 4 0, 4 4, 0 4, 0 0),\n (1 1,3 1,3 3,1 3))");
  EXPECT_DOUBLE_EQ(readGeometryFile<2>(ring)->volume().value, 12);
  const auto two =
      writeFile("b.wkt", "MULTIPOLYGON (((0 0, 1 0, 1 1)), ((5 5, 6 5, 6 6.0, 5 6e0)))");
  EXPECT_DOUBLE_EQ(readGeometryFile<2>(two)->volume().value, 1.5);
}

TEST(Polygon, ReadsPlainLoopsInAnyOrder) {
  const auto path =
      writeFile("a.txt",
                "# the hole first\n1 1\n3, 1\n3 3\n# still the hole\n1 3\n\n"
                "0 0\n4 0\n4 4\n0 4\n\n\n1.5 1.5 # an island\n2.5 1.5\n2.5 2.5\n1.5 2.5\n");
  const auto polygon = readGeometryFile<2>(path);
  EXPECT_DOUBLE_EQ(polygon->volume().value, 13);
  EXPECT_TRUE(polygon->isInside({{2, 2}}));
  EXPECT_FALSE(polygon->isInside({{1.25, 2}}));
}

TEST(Polygon, FilesAreScaledTurnedAndMoved) {
  FileOptions<2> options;
  options.placement.scale = 0.001;
  options.placement.rotate(90, {0, 0, 1});
  options.placement.translation = {{1, 0}};
  const auto polygon =
      readGeometryFile<2>(writeFile("a.txt", "0 0\n2000 0\n2000 1000\n0 1000\n"), options);
  EXPECT_NEAR(polygon->volume().value, 2, 1e-12);
  EXPECT_TRUE(polygon->isInside({{0.5, 1.5}}));
}

TEST(Polygon, CaseEntriesHoldPolygons) {
  const CaseNode root = CaseNode::parse(
      "[geometry]\na = { polygon = { points = [[0, 0], [4, 0], [4, 4], [0, 4]], "
      "holes = [[[1, 1], [3, 1], [3, 3], [1, 3]]] } }\n",
      "case.toml");
  const auto set = GeometrySet<2>::read(*root.find("geometry"), ".");
  EXPECT_DOUBLE_EQ(regionNamed(set, "a")->volume().value, 12);
  const CaseNode bad = CaseNode::parse(
      "[geometry]\na = { polygon = { points = [[0, 0], [4, 4], [4, 0], [0, 4]] } }\n", "case.toml");
  expectError([&] { GeometrySet<2>::read(*bad.find("geometry"), "."); },
              {"case.toml:2", "geometry.a.polygon", "crosses or touches itself at (2, 2)"});
}

TEST(Polygon, RefusesWhatIsNoPolygon) {
  expectFileError<2>("a.txt", "0 0\n1 0\n", {"2 different corners", "3 or more"});
  expectFileError<2>("b.txt", "0 0\n4 4\n4 0\n0 4\n", {"itself at (2, 2)", "simple"});
  expectFileError<2>("c.txt", "0 0\n4 0\n2 0\n2 3\n", {"crosses or touches itself"});
  expectFileError<2>("d.wkt", "POLYGON((0 0, 4 0, 4 4, 0 4), (5 5, 6 5, 6 6))",
                     {"a hole lies outside", "(5, 5)"});
  expectFileError<2>("e.wkt",
                     "POLYGON((0 0, 4 0, 4 4, 0 4), (1 1, 3 1, 3 3), (2 1.5, 2.5 1.5, 2.5 2))",
                     {"a hole lies inside another"});
  expectFileError<2>("f.wkt", "POLYGON((0 0, 4 0, 4 4, 0 4), (3 1, 5 1, 5 3, 3 3))",
                     {"two loops cross", "(4, "});
  expectFileError<2>("g.wkt", "MULTIPOLYGON(((0 0, 4 0, 4 4)), ((2 1, 3 1, 3 2)))", {"overlap"});
}

TEST(Polygon, RefusesBadFiles) {
  expectFileError<2>("a.wkt", "POLYGON((0 0, 4 0, 4 4, 0", {"truncated", ":1:"});
  expectFileError<2>("b.wkt", "POLYGON Z((0 0 0, 4 0 0, 4 4 0))", {"x y"});
  expectFileError<2>("c.wkt", "LINESTRING(0 0, 4 0)", {"linestring", "POLYGON"});
  expectFileError<2>("d.txt", "0 0\n1 nan\n1 1\n", {":2:", "finite"});
  expectFileError<2>("e.txt", "0 0\n1\n1 1\n", {":2:", "1 number"});
  expectFileError<2>("f.txt", "0 0\n1 one\n", {":2:", "'one' is not a number"});
  expectFileError<2>("g.txt", "", {"is empty"});
  expectFileError<2>("h.txt", std::string("\0\1\2", 3), {"is not text"});
  expectFileError<2>("i.txt", "# nothing\n", {"no polygon"});
  expectFileError<2>("j.foo", "0 0\n", {"'.foo' are not read", ".wkt"});
  expectFileError<3>("k.wkt", "POLYGON((0 0, 1 0, 1 1))", {"2-D", "dimension = 3"});
  expectError([] { readGeometryFile<2>("nowhere/none.wkt"); }, {"none.wkt", "no such file"});
}

TEST(Polygon, TwoThreadsSeeTheSame) {
  const auto polygon = makePolygon({{star(50, 2, 3), {}}}, "test");
  Random<2> random;
  std::vector<Vec<2>> points(20000);
  for (Vec<2>& x : points) x = random.inBox(surroundings);
  std::vector<double> alone(points.size()), first(points.size()), second(points.size());
  std::thread one([&] { polygon->signedDistance(points, first); });
  std::thread two([&] { polygon->signedDistance(points, second); });
  one.join();
  two.join();
  polygon->signedDistance(points, alone);
  EXPECT_EQ(alone, first);
  EXPECT_EQ(alone, second);
}

}  // namespace
}  // namespace plenum::test
