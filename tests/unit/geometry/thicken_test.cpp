// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/thicken.hpp"

#include "files_for_tests.hpp"
#include "geometry/box_shape.hpp"
#include "geometry/geometry_set.hpp"
#include "geometry/set_operation.hpp"
#include "probe.hpp"
#include "tests/support/named_region.hpp"

#include <fmt/format.h>

#include <numbers>

namespace plenum::test {
namespace {

constexpr double pi = std::numbers::pi;

using Corners = std::vector<Vec<3>>;
using Facets = std::vector<std::array<Vec<3>, 3>>;

std::string stlOf(const Facets& facets) {
  std::string text = "solid\n";
  for (const auto& facet : facets) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const Vec<3>& x : facet) text += fmt::format("vertex {} {} {}\n", x[0], x[1], x[2]);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid\n";
}

/// Two triangles.
void addSquare(Facets& facets, const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d) {
  facets.push_back({a, b, c});
  facets.push_back({a, c, d});
}

/// Bottom and sides of a box of 2 x 1 x 0.5 m, normals out of the box.
Facets openBox() {
  const auto at = [](double x, double y, double z) { return Vec<3>{{x, y, z}}; };
  Facets facets;
  addSquare(facets, at(0, 0, 0), at(0, 1, 0), at(2, 1, 0), at(2, 0, 0));
  addSquare(facets, at(0, 0, 0), at(2, 0, 0), at(2, 0, 0.5), at(0, 0, 0.5));
  addSquare(facets, at(0, 1, 0), at(0, 1, 0.5), at(2, 1, 0.5), at(2, 1, 0));
  addSquare(facets, at(0, 0, 0), at(0, 0, 0.5), at(0, 1, 0.5), at(0, 1, 0));
  addSquare(facets, at(2, 0, 0), at(2, 1, 0), at(2, 1, 0.5), at(2, 0, 0.5));
  return facets;
}

/// x = grid of u (0 ... nU) and v (0 ... nV), each square cut in two.
template <class Point>
Facets gridOf(int nU, int nV, Point&& point) {
  Facets facets;
  for (int u = 0; u < nU; ++u)
    for (int v = 0; v < nV; ++v)
      addSquare(facets, point(u, v), point(u + 1, v), point(u + 1, v + 1), point(u, v + 1));
  return facets;
}

/// The tube of radius 1 around z from 0 to 1, normals away from the axis.
Facets tube(int n) {
  return gridOf(n, 1, [&](int u, int v) {
    const double angle = 2 * pi * (u % n) / n;
    return Vec<3>{{std::cos(angle), std::sin(angle), static_cast<double>(v)}};
  });
}

template <int Dim>
GeometryPtr<Dim> wallOf(const std::string& name, const std::string& content, double thickness,
                        WallSide side = WallSide::outer, std::vector<Finding>* findings = nullptr) {
  FileOptions<Dim> options;
  options.thickening = Thickening{thickness, side};
  if (findings != nullptr)
    options.report = [=](const Finding& finding) { findings->push_back(finding); };
  return readGeometryFile<Dim>(writeFile(name, content), options);
}

template <int Dim>
void expectNoWall(const std::string& name, const std::string& content, double thickness,
                  WallSide side, std::vector<std::string> words) {
  words.push_back(name);
  expectError([&] { wallOf<Dim>(name, content, thickness, side); }, words);
}

/// The open box grown by `outwards` without that shrunk by `inwards`: bottom and sides.
GeometryPtr<3> boxesOf(double outwards, double inwards) {
  const double a = outwards, b = inwards;
  return differenceOf<3>({makeGeometry(BoxShape<3>{{{{-a, -a, -a}}, {{2 + a, 1 + a, 0.5}}, {}}}),
                          makeGeometry(BoxShape<3>{{{{b, b, b}}, {{2 - b, 1 - b, 0.6}}, {}}})});
}

TEST(Thicken, OpenBoxOnEitherSide) {
  const double t = 0.125;
  const Box<3> around{{{-0.5, -0.5, -0.5}}, {{2.5, 1.5, 1}}, {}};
  for (const auto& [side, a, b] : {std::tuple{WallSide::outer, t, 0.},
                                   {WallSide::inner, 0., t},
                                   {WallSide::middle, t / 2, t / 2}}) {
    const auto wall = wallOf<3>("box.stl", stlOf(openBox()), t, side);
    const auto exact = boxesOf(a, b);
    const double outside = (2 + 2 * a) * (1 + 2 * a) * (0.5 + a);
    EXPECT_NEAR(wall->volume().value, outside - (2 - 2 * b) * (1 - 2 * b) * (0.5 - b), 1e-14);
    Random<3> random;
    for (int k = 0; k < 300; ++k) {  // round-off of set operations, 1e-10 of the size
      const Vec<3> x = random.inBox(around);
      ASSERT_NEAR(wall->signedDistance(x), exact->signedDistance(x), 1e-9);
    }
  }
}

TEST(Thicken, ThicknessIsALengthOfTheScene) {
  FileOptions<3> options;
  options.thickening = Thickening{0.01, WallSide::outer};
  options.placement.scale = 0.1;
  options.placement.rotate(90, {0, 0, 1});
  options.placement.translation = {{1, 0, 0}};
  const auto wall = readGeometryFile<3>(writeFile("box.stl", stlOf(openBox())), options);
  EXPECT_NEAR(wall->volume().value, 0.22 * 0.12 * 0.06 - 0.2 * 0.1 * 0.05, 1e-15);
  EXPECT_NEAR(norm(wall->bounds().upper - Vec<3>{{1.01, 0.21, 0.05}}), 0, 1e-15);
}

TEST(Thicken, SheetIsAPlate) {
  const auto plate = gridOf(7, 3, [](int u, int v) { return Vec<3>{{u / 7., v / 3., u / 7.}}; });
  const auto wall = wallOf<3>("sheet.stl", stlOf(plate), 0.1);
  EXPECT_NEAR(wall->volume().value, std::sqrt(2.) * 0.1, 1e-14);
  EXPECT_TRUE(wall->isInside({{0.5 - 0.01, 0.5, 0.5 + 0.01}}));  // normals have z > 0
  EXPECT_FALSE(wall->isInside({{0.5 + 0.01, 0.5, 0.5 - 0.01}}));
}

TEST(Thicken, BowlHasItsThicknessEverywhere) {
  const int n = 48;  // along the equator; a hole of radius .13 at the pole
  const auto bowl = gridOf(n, n / 4 - 1, [&](int u, int v) {
    const double angle = 2 * pi * (u % n) / n, height = pi / 2 * v / (n / 4.);
    return Vec<3>{
        {std::cos(angle) * std::cos(height), std::sin(angle) * std::cos(height), std::sin(height)}};
  });
  // A corner's faces are pi/48 from its own direction; that enters squared.
  const double coarse = 2 * (pi / n) * (pi / n);
  for (const auto& [side, lower, upper] :
       {std::tuple{WallSide::outer, 1., 1.25}, {WallSide::inner, 0.75, 1.}}) {
    const auto wall = wallOf<3>("bowl.stl", stlOf(bowl), 0.25, side);
    const double share = std::sin(pi / 2 * (1 - 4. / n));  // of the half ball's volume
    const double volume = 2 * pi / 3 * (std::pow(upper, 3) - std::pow(lower, 3)) * share;
    EXPECT_NEAR(wall->volume().value, volume, 3 * coarse * volume);
    Random<3> random;
    for (int k = 0; k < 500; ++k) {
      Vec<3> d = random.direction();
      d[2] = std::abs(d[2]);
      if (d[2] > 0.8 || d[2] < 0.3) continue;  // away from both rims
      EXPECT_NEAR(wall->signedDistance(0.5 * (lower + upper) * d), -0.125, coarse);
    }
  }
}

TEST(Thicken, OpenMeshesOfOtherFormats) {
  const std::string off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 "
      "0\n0 1 0\n4 0 1 2 3\n";
  for (const auto& [name, text] : {std::pair{"a.off", off}, {"a.obj", obj}, {"a.ply", ply}}) {
    const auto wall = wallOf<3>(name, text, 0.5);
    EXPECT_DOUBLE_EQ(wall->volume().value, 0.5);
    EXPECT_EQ(wall->bounds().upper[2], 0.5);
  }
}

TEST(Thicken, TurnsWhatIsTurnedAgainstTheRest) {
  Facets facets = openBox();
  std::swap(facets[3][0], facets[3][1]);
  std::vector<Finding> findings;
  const auto wall = wallOf<3>("turned.stl", stlOf(facets), 0.125, WallSide::outer, &findings);
  EXPECT_NEAR(wall->volume().value, 2.25 * 1.25 * 0.625 - 1, 1e-14);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NE(findings[0].what.find("1 triangle was turned"), std::string::npos) << findings[0].what;
}

TEST(Thicken, SaysWhereFourPlanesSpoilTheThickness) {
  // The tip of a pyramid whose base is not square: no point has one distance from all four planes.
  const Vec<3> tip{{0, 0, 1}};
  const Corners base = {{{2, 0, 0}}, {{0, 0.7, 0}}, {{-2, 0, 0}}, {{0.5, -0.4, 0}}};
  Facets facets;
  for (std::size_t k = 0; k < 4; ++k) facets.push_back({base[k], base[(k + 1) % 4], tip});
  std::vector<Finding> findings;
  wallOf<3>("tip.stl", stlOf(facets), 0.01, WallSide::outer, &findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::warning);
  EXPECT_NE(findings[0].what.find("(0, 0, 1)"), std::string::npos) << findings[0].what;
}

TEST(Thicken, RefusesMoreThanTheRadiusOfCurvature) {
  wallOf<3>("tube.stl", stlOf(tube(24)), 0.9, WallSide::inner);  // room for it
  wallOf<3>("tube.stl", stlOf(tube(24)), 5, WallSide::outer);
  expectNoWall<3>("tube.stl", stlOf(tube(24)), 1.1, WallSide::inner,
                  {"1.1 m", "radius of curvature near (", "smaller thickness", "side = \"outer\""});
  expectNoWall<3>("box.stl", stlOf(openBox()), 0.6, WallSide::inner, {"radius of curvature"});
}

/// A scroll: one and a half turns, 0.1 m apart.
Facets scroll() {
  return gridOf(36, 1, [](int u, int v) {
    const double angle = 2 * pi * u / 24, r = 1 + 0.1 * u / 24;
    return Vec<3>{{r * std::cos(angle), r * std::sin(angle), static_cast<double>(v)}};
  });
}

TEST(Thicken, RefusesWallsThatMeetThemselves) {
  wallOf<3>("scroll.stl", stlOf(scroll()), 0.08);
  expectNoWall<3>("scroll.stl", stlOf(scroll()), 0.12, WallSide::outer,
                  {"crosses itself", "thickness = 0.12", "smaller thickness"});
}

TEST(Thicken, RefusesSurfacesThatAreClosed) {
  Facets closed = openBox();
  addSquare(closed, {{0, 0, 0.5}}, {{2, 0, 0.5}}, {{2, 1, 0.5}}, {{0, 1, 0.5}});
  expectNoWall<3>("closed.stl", stlOf(closed), 0.1, WallSide::outer,
                  {"is closed", "remove thickness", "difference"});
}

TEST(Thicken, RefusesSurfacesOfOneSide) {
  const int n = 24;
  const auto strip = gridOf(n, 1, [&](int u, int v) {
    const double turn = 2 * pi * (u % n) / n;
    const double twist = turn / 2;
    const double way = (u == n ? -1 : 1) * (v == 0 ? -0.25 : 0.25);  // joined upside down
    const double r = 1 + way * std::cos(twist);
    return Vec<3>{{r * std::cos(turn), r * std::sin(turn), way * std::sin(twist)}};
  });
  expectNoWall<3>("moebius.stl", stlOf(strip), 0.02, WallSide::outer, {"only one side", "cut it"});
}

TEST(Thicken, RefusesBranches) {
  Facets facets;
  for (const Vec<3>& arm : {Vec<3>{{1, 0, 0}}, {{-1, 0, 0}}, {{0, 1, 0}}})
    addSquare(facets, {{0, 0, 0}}, arm, arm + Vec<3>{{0, 0, 1}}, {{0, 0, 1}});
  expectNoWall<3>("branch.stl", stlOf(facets), 0.02, WallSide::outer, {"not one sheet", "union"});
}

TEST(Thicken, OpenMeshesWithoutThicknessNameIt) {
  expectFileError<3>("open.stl", stlOf(openBox()), {"not closed", "give a thickness"});
}

TEST(Thicken, LinesInThePlane) {
  // A trough; drawn this way round the right of the line is below and outside.
  const std::string trough = "LINESTRING (0 1, 0 0, 2 0, 2 1)";
  const auto outer = wallOf<2>("trough.wkt", trough, 0.25);
  EXPECT_DOUBLE_EQ(outer->volume().value, 2.5 * 1.25 - 2);
  EXPECT_EQ(outer->bounds().lower, (Vec<2>{{-0.25, -0.25}}));
  EXPECT_EQ(outer->bounds().upper, (Vec<2>{{2.25, 1}}));
  const auto inner = wallOf<2>("trough.wkt", trough, 0.25, WallSide::inner);
  EXPECT_DOUBLE_EQ(inner->volume().value, 2 - 1.5 * 0.75);
  const auto middle = wallOf<2>("trough.wkt", trough, 0.25, WallSide::middle);
  EXPECT_DOUBLE_EQ(middle->volume().value, 2.25 * 1.125 - 1.75 * 0.875);
  const auto plain = wallOf<2>("trough.txt", "0 1\n0 0\n2 0\n2 1\n\n4 0\n5 0\n", 0.25);
  EXPECT_DOUBLE_EQ(plain->volume().value, outer->volume().value + 0.25);
  const auto two = wallOf<2>("two.wkt", "MultiLineString ((0 0, 1 0), (0 1, 1 1, 1 2))", 0.5);
  EXPECT_DOUBLE_EQ(two->volume().value, 0.5 + 2 * 0.5 + 0.25);
}

TEST(Thicken, RefusesLinesThatMakeNoWall) {
  using enum WallSide;
  expectNoWall<2>("a.wkt", "LINESTRING (0 0, 1 0, 1 1, 0 0)", 0.1, outer,
                  {"is closed", "(0, 0)", "remove thickness"});
  expectNoWall<2>("b.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 0))", 0.1, outer,
                  {"b.wkt:1", "closed polygon", "LINESTRING"});
  expectNoWall<2>("c.wkt", "LINESTRING (0 0)", 0.1, outer, {"only one corner", "two or more"});
  expectNoWall<2>("d.wkt", "LINESTRING (0 0, 1 0, 0 0.01)", 0.1, outer,
                  {"runs back", "(1, 0)", "12 degrees"});
  expectNoWall<2>("e.wkt", "LINESTRING (0 1, 0 0, 0.3 0, 0.3 1)", 0.2, inner,
                  {"0.2 m", "near (0.15, 0)", "side = \"outer\""});
  expectNoWall<2>("f.wkt", "LINESTRING (0 0, 0 1, 2 1, 2 0.2, 0.3 0.2)", 0.35, outer,
                  {"crosses", "thickness = 0.35", "smaller thickness"});
  expectNoWall<2>("g.wkt", "MULTILINESTRING ((0 0, 1 0), (1 0, 1 1))", 0.1, outer,
                  {"two loops cross or touch"});
  expectNoWall<2>("h.wkt", "POINT (0 0)", 0.1, outer, {"not a line", "LINESTRING"});
  expectFileError<2>("open.wkt", "LINESTRING (0 0, 1 0)", {"open line", "thickness beside file"});
}

TEST(Thicken, CadFilesAreRefused) {
  expectNoWall<3>("a.step", "x", 0.1, WallSide::outer, {"thickness", "export the surface"});
  expectNoWall<2>("a.geo", "x", 0.1, WallSide::outer, {"thickness", "export the line"});
}

TEST(Thicken, KeysOfTheCase) {
  const auto path = writeFile("box.stl", stlOf(openBox())).string();
  const auto read = [&](const std::string& keys) {
    const std::string text = "[geometry]\ntank = { file = \"" + path + "\"" + keys + " }\n";
    return regionNamed(
               GeometrySet<3>::read(*CaseNode::parse(text, "case.toml").find("geometry"), "."),
               "tank")
        ->volume()
        .value;
  };
  EXPECT_NEAR(read(", thickness = 0.1"), 2.2 * 1.2 * 0.6 - 1, 1e-14);
  EXPECT_NEAR(read(", thickness = 0.1, side = \"inner\""), 1 - 1.8 * 0.8 * 0.4, 1e-14);
  expectError([&] { read(", thickness = -0.1"); },
              {"geometry.tank.thickness", "> 0", "side = \"inner\""});
  expectError([&] { read(", thickness = 0"); }, {"must be > 0"});
  expectError([&] { read(", side = \"inner\""); }, {"geometry.tank.side", "give thickness"});
  expectError([&] { read(", thickness = 0.1, side = \"left\""); }, {"outer | inner | middle"});
  expectError(
      [&] {
        GeometrySet<3>::read(
            *CaseNode::parse("[geometry]\na = { ball = { center = [0, 0, 0], radius = 1 }, "
                             "thickness = 0.1 }",
                             "case.toml")
                 .find("geometry"),
            ".");
      },
      {"concerns files only"});
}

}  // namespace
}  // namespace plenum::test
