// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same geometry from every kind of file agrees with the analytic one within the tolerance.
#include "files_for_tests.hpp"
#include "geometry/box_shape.hpp"
#include "geometry/cad_file.hpp"
#include "geometry/round_shapes.hpp"
#include "geometry/set_operation.hpp"
#include "geometry/text_reader.hpp"
#include "probe.hpp"

#include <iostream>
#include <numbers>

namespace plenum::test {
namespace {

constexpr double pi = std::numbers::pi;
const std::filesystem::path scripts = PLENUM_CAD_SCRIPTS;
const std::filesystem::path files = PLENUM_CAD_FILES;

/// Signed distances differ by no more than `tolerance`, at `n` random points of `box`.
template <int Dim>
void expectAgree(const Geometry<Dim>& geometry, const Geometry<Dim>& exact, const Box<Dim>& box,
                 int n, double tolerance) {
  Random<Dim> random;
  double largest = 0;
  for (int k = 0; k < n; ++k) {
    const Vec<Dim> x = random.inBox(box);
    largest = std::max(largest, std::abs(geometry.signedDistance(x) - exact.signedDistance(x)));
  }
  EXPECT_LE(largest, tolerance) << geometry.describe();
  EXPECT_NEAR(norm(geometry.bounds().lower - exact.bounds().lower), 0, 2 * tolerance);
  EXPECT_NEAR(norm(geometry.bounds().upper - exact.bounds().upper), 0, 2 * tolerance);
}

void expectAnnulus(const Geometry<2>& geometry, double tolerance) {
  const auto exact = makeGeometry(Annulus{{}, 0.04, 0.10});
  // A strip of the tolerance along both circles.
  const double perimeter = 2 * pi * 0.14;
  EXPECT_NEAR(geometry.volume().value, exact->volume().value, tolerance * perimeter)
      << geometry.describe();
  expectAgree<2>(geometry, *exact, {{{-0.15, -0.15}}, {{0.15, 0.15}}, {}}, 5000, tolerance);
}

TEST(Cad, AnnulusIsTheSameFromEveryFile) {
  for (const double tolerance : {1e-3, 1e-5}) {
    FileOptions<2> options;
    options.tolerance = tolerance;
    for (const auto& path :
         {scripts / "annulus.geo", files / "annulus.step", files / "annulus.brep"}) {
      const auto geometry = readGeometryFile<2>(path, options);
      EXPECT_EQ(geometry->tolerance(), tolerance);
      expectAnnulus(*geometry, tolerance);
    }
  }
  // These come with corners of their own: chords of 1e-4 m at most, 256 edges on a circle.
  expectAnnulus(*readGeometryFile<2>(files / "annulus.wkt"), 1e-4);
  expectAnnulus(*readGeometryFile<2>(files / "annulus.msh"), 0.1 * (1 - std::cos(pi / 256)) * 1.1);
}

TEST(Cad, DefaultToleranceFollowsTheSize) {
  const auto geometry = readGeometryFile<2>(files / "annulus.step");
  EXPECT_NEAR(geometry->tolerance(), 1e-4 * 0.2 * std::sqrt(2.), 1e-9);  // gmsh's bounds are loose
  expectAnnulus(*geometry, geometry->tolerance());
  EXPECT_EQ(readGeometryFile<2>(files / "annulus.msh")->tolerance(), 0);  // it is what it is
}

TEST(Cad, EndingsMayBeInCapitals) {
  const auto bytes = [](const char* name) { return readWholeFile(files / name); };
  const auto flat = readGeometryFile<2>(writeFile("FLAT.MSH", bytes("annulus.msh")));
  EXPECT_EQ(flat->volume().value, readGeometryFile<2>(files / "annulus.msh")->volume().value);
  const auto solid = readGeometryFile<3>(writeFile("SOLID.MSH", bytes("box_minus_cylinder.msh")));
  EXPECT_EQ(solid->volume().value,
            readGeometryFile<3>(files / "box_minus_cylinder.msh")->volume().value);
}

TEST(Cad, MeasuredDeviationIsWithinTheTolerance) {
  const CadLoops flat = readCadLoops(files / "annulus.step", 1e-4, 0);
  EXPECT_EQ(flat.loops.size(), 2u);
  EXPECT_LE(flat.deviation, 1e-4);
  EXPECT_GT(flat.deviation, 1e-6);  // it was measured
  const CadSurface solid = readCadSurface(files / "box_minus_cylinder.step", 1e-3, 0);
  EXPECT_LE(solid.deviation, 1e-3);
  EXPECT_GT(solid.deviation, 1e-5);
}

TEST(Cad, BoxMinusCylinderIsTheSameFromEveryFile) {
  const auto exact =
      differenceOf<3>({makeGeometry(BoxShape<3>{{{{-0.5, -0.5, -0.25}}, {{0.5, 0.5, 0.25}}, {}}}),
                       makeGeometry(Cylinder{{{0, 0, -1}}, {{0, 0, 1}}, 0.25})});
  const double volume = 0.5 * (1 - pi / 16);
  const double side = 2 * pi * 0.25 * 0.5;  // of the hole: where triangles differ from the surface
  const auto expectSame = [&](const std::filesystem::path& path, double tolerance) {
    FileOptions<3> options;
    options.tolerance = tolerance;
    const auto geometry = readGeometryFile<3>(path, options);
    EXPECT_NEAR(geometry->volume().value, volume, tolerance * side) << path;
    expectAgree<3>(*geometry, *exact, {{{-0.8, -0.8, -0.5}}, {{0.8, 0.8, 0.5}}, {}}, 2000,
                   tolerance);
  };
  expectSame(scripts / "box_minus_cylinder.geo", 1e-3);
  expectSame(files / "box_minus_cylinder.step", 1e-3);
  expectSame(files / "box_minus_cylinder.brep", 1e-3);
  expectSame(files / "box_minus_cylinder.stl", 1e-4);  // its own tolerance
  expectSame(files / "box_minus_cylinder.msh", 0.25 * (1 - std::cos(pi / 64)) * 2);  // 64 edges
}

// A cavity and a surface that curves two ways: the ball inside the box.
TEST(Cad, CurvedCavity) {
  const auto script = writeFile("cavity.geo",
                                "SetFactory(\"OpenCASCADE\");\nBox(1) = {-1, -1, -1, 2, 2, 2};\n"
                                "Sphere(2) = {0, 0, 0, 0.5};\n"
                                "BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n");
  FileOptions<3> options;
  options.tolerance = 2e-3;
  const auto geometry = readGeometryFile<3>(script, options);
  EXPECT_NEAR(geometry->volume().value, 8 - 4 * pi / 3 / 8, 2e-3 * pi);
  EXPECT_FALSE(geometry->isInside({{0, 0, 0}}));
  EXPECT_NEAR(geometry->signedDistance({{0, 0, 0.1}}), 0.4, 2e-3);
}

TEST(Cad, StepFilesAreReadInMetres) {
  // The same part by a program that works in millimetres: its numbers are a thousand times larger.
  std::ifstream in(files / "annulus.step");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  EXPECT_NE(text.find("SI_UNIT(.MILLI.,.METRE.)"), std::string::npos);
  EXPECT_NE(text.find(",100.)"), std::string::npos);  // the outer radius
  EXPECT_NEAR(readGeometryFile<2>(files / "annulus.step")->bounds().upper[0], 0.1, 1e-6);
}

TEST(Cad, FilesAreScaledTurnedAndMoved) {
  FileOptions<2> options;
  options.tolerance = 1e-2;
  options.placement.scale = 10;
  options.placement.translation = {{5, 0}};
  const auto geometry = readGeometryFile<2>(scripts / "annulus.geo", options);
  const auto exact = makeGeometry(Annulus{{{5, 0}}, 0.4, 1.0});
  expectAgree<2>(*geometry, *exact, {{{3, -2}}, {{7, 2}}, {}}, 1000, 1e-2);
  EXPECT_EQ(geometry->tolerance(), 1e-2);
}

TEST(Cad, SurfacesThatShareACurveAreOneRegion) {
  const auto script = writeFile("two.geo",
                                "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\n"
                                "Rectangle(2) = {1, 0, 0, 1, 1};\nCoherence;\n");
  const auto geometry = readGeometryFile<2>(script);
  EXPECT_DOUBLE_EQ(geometry->volume().value, 2);
  EXPECT_NEAR(geometry->signedDistance({{1, 0.6}}), -0.4, 1e-14);
}

TEST(Cad, BuiltInKernelScripts) {
  const auto script =
      writeFile("plate.geo",
                "Point(1) = {0,0,0}; Point(2) = {2,0,0}; Point(3) = {2,1,0}; Point(4) = {0,1,0};\n"
                "Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1};\n"
                "Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1};\n");
  EXPECT_DOUBLE_EQ(readGeometryFile<2>(script)->volume().value, 2);
}

TEST(Cad, RefusesAnotherDimension) {
  expectError([] { readGeometryFile<3>(files / "annulus.step"); },
              {"annulus.step", "is flat", "along z", "dimension = 2"});
  expectError([] { readGeometryFile<3>(files / "annulus.msh"); }, {"is flat"});
  expectError([] { readGeometryFile<2>(files / "box_minus_cylinder.step"); },
              {"box_minus_cylinder.step", "is 3-D", "dimension = 3"});
  expectError([] { readGeometryFile<2>(files / "box_minus_cylinder.msh"); }, {"is 3-D"});
  expectFileError<2>("upright.geo",
                     "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\n"
                     "Rotate {{1, 0, 0}, {0, 0, 0}, Pi/2} { Surface{1}; }\n",
                     {"not flat in the x-y plane", "rotate it"});
  expectFileError<2>("lines.geo", "Point(1) = {0,0,0}; Point(2) = {1,0,0}; Line(1) = {1,2};\n",
                     {"no surface", "plane surface"});
}

TEST(Cad, RefusesOpenSurfaces) {
  expectFileError<3>("open.geo",
                     "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\n"
                     "Delete { Volume{1}; }\nDelete { Surface{1}; }\n",
                     {"not closed", "close the holes"});
}

TEST(Cad, RefusesBadFiles) {
  for (const char* ending : {".geo", ".step", ".brep", ".msh"}) {
    expectError([&] { readGeometryFile<2>("nowhere" + std::string(ending)); }, {"no such file"});
    expectFileError<2>("empty" + std::string(ending), "", {"is empty"});
    expectFileError<2>("bad" + std::string(ending), "hello (\n", {"gmsh", "export it again"});
  }
  for (const char* name : {"annulus.step", "annulus.brep", "annulus.msh"}) {
    std::ifstream in(files / name);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    expectFileError<2>(name, text.substr(0, text.size() / 2), {"gmsh", "truncated"});
  }
}

TEST(Cad, NothingIsPrinted) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  readGeometryFile<2>(files / "annulus.step");
  const auto bad = writeFile("bad.step", "hello\n");
  EXPECT_THROW(readGeometryFile<2>(bad), InputError);
  std::cout.flush();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace plenum::test
