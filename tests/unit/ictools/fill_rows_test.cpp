// SPDX-License-Identifier: GPL-3.0-or-later
//
// Filling by runs of rows gives the points that asking for every signed distance gives.
#include "bench/meshes.hpp"
#include "geometry/box_shape.hpp"
#include "geometry/extrusion.hpp"
#include "geometry/placement.hpp"
#include "geometry/round_shapes.hpp"
#include "geometry/set_operation.hpp"
#include "geometry/surface_mesh.hpp"
#include "ictools/fill.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

template <int Dim>
void expectSamePoints(const Geometry<Dim>& geometry, const Lattice<Dim>& lattice,
                      const Box<Dim>& box) {
  const double roundOff = surfaceRoundOff * lattice.edges()[0];
  std::vector<Vec<Dim>> expected;
  const std::vector<Vec<Dim>> all = latticePoints(lattice, box);
  const std::vector<double> distances = signedDistances<Dim>(geometry, all);
  for (std::size_t k = 0; k < all.size(); ++k)
    if (distances[k] <= -roundOff) expected.push_back(all[k]);
  ASSERT_GT(expected.size(), 20u);
  ASSERT_LT(expected.size(), all.size());
  EXPECT_EQ(latticePoints(lattice, box, geometry, {.upper = -roundOff}), expected)
      << geometry.describe();
}

/// Lattices of all kinds: at the corner of the box by the half-spacing rule, and with a point at
/// zero.
template <int Dim>
void expectSamePoints(const Geometry<Dim>& geometry, double spacing,
                      const std::vector<std::string>& lattices = latticeNames(Dim)) {
  const Box<Dim> box = geometry.bounds().grown(1.5 * spacing);
  for (const std::string& name : lattices) {
    Lattice<Dim> lattice(name, spacing);
    expectSamePoints(geometry, lattice, box);
    lattice.startAt(geometry.bounds().lower);
    expectSamePoints(geometry, lattice, box);
  }
}

template <int Dim>
GeometryPtr<Dim> boxOf(const Vec<Dim>& lower, const Vec<Dim>& upper) {
  return makeGeometry(BoxShape<Dim>{{lower, upper, {}}});
}

// With a point at zero, faces, edges and corners at multiples of the spacing bear lattice points.
TEST(FillRows, AlignedShapes) {
  expectSamePoints(*boxOf<1>({{-1}}, {{1}}), 0.015625);
  expectSamePoints(*boxOf<2>({{-1, -1}}, {{1, 0.5}}), 0.0625);
  expectSamePoints(*boxOf<3>({{-1, -1, -1}}, {{1, 0.5, 1}}), 0.125);
  expectSamePoints(*makeGeometry(Ball<2>{{}, 0.9}), 0.1);
  expectSamePoints(*makeGeometry(Annulus{{}, 0.5, 1}), 0.1);
  expectSamePoints(*makeGeometry(Ball<3>{{}, 1}), 0.125);
  expectSamePoints(*makeGeometry(Cylinder{{{-1, 0, 0}}, {{1, 0, 0}}, 0.5}), 0.125);
  expectSamePoints(*makeGeometry(Cylinder{{{0, 0, -1}}, {{0, 0, 1}}, 0.5}), 0.125);
}

TEST(FillRows, Extrusions) {
  const auto disk = makeGeometry(Ball<2>{{{0.25, 0}}, 0.5});
  const auto rod = extruded(disk, -1, 1);
  const auto cylinder = makeGeometry(Cylinder{{{0.25, 0, -1}}, {{0.25, 0, 1}}, 0.5});
  const auto bar = extruded(boxOf<2>({{-1, -0.5}}, {{1, 0.5}}), -0.25, 1);
  const auto box = boxOf<3>({{-1, -0.5, -0.25}}, {{1, 0.5, 1}});
  expectSamePoints(*rod, 0.125);
  expectSamePoints(*bar, 0.125);
  Placement<3> lying;  // rows along z in the frame of the extrusion
  lying.rotate(90, {0, 1, 0});
  expectSamePoints(*placed(rod, lying), 0.125);
  for (const std::string& name : latticeNames(3)) {
    const Lattice<3> lattice(name, 0.125);
    const DistanceBand inside{.upper = -surfaceRoundOff * 0.125};
    const Box<3> around = box->bounds().grown(0.25);
    EXPECT_EQ(latticePoints(lattice, around, *rod, inside),
              latticePoints(lattice, around, *cylinder, inside));
    EXPECT_EQ(latticePoints(lattice, around, *bar, inside),
              latticePoints(lattice, around, *box, inside));
  }
}

TEST(FillRows, SetOperations) {
  const auto disk = makeGeometry(Ball<2>{{{0.25, 0}}, 0.75});
  const auto square = boxOf<2>({{-1, -0.5}}, {{0.5, 0.5}});
  expectSamePoints(*unionOf<2>({disk, square}), 0.0625);
  expectSamePoints(*intersectionOf<2>({disk, square}), 0.0625);
  expectSamePoints(*differenceOf<2>({square, disk}), 0.0625);
  // Parts that share a face, a part of a face, an edge; a lattice point on each of them.
  const auto seam = unionOf<2>({square, boxOf<2>({{0.5, -0.25}}, {{1, 0.75}})});
  expectSamePoints(*seam, 0.0625);
  expectSamePoints(*differenceOf<2>({seam, disk}), 0.0625);
  const auto cube = boxOf<3>({{-1, -1, -1}}, {{1, 1, 1}});
  expectSamePoints(*differenceOf<3>({cube, makeGeometry(Cylinder{{{0, 0, -1}}, {{0, 0, 1}}, 0.5})}),
                   0.25, {"cubic"});  // exact distances of solid set operations take their time
  expectSamePoints(*unionOf<3>({cube, boxOf<3>({{1, -1, 0}}, {{2, 1, 1}})}), 0.25, {"cubic"});
}

TEST(FillRows, TurnedShapes) {
  for (const double angle : {30., 45., 90., 180.}) {
    Placement<3> placement;
    placement.rotate(angle, {0, 0, 1});
    placement.scale = 0.5;
    const auto cube = boxOf<3>({{-2, -2, -2}}, {{2, 2, 2}});
    const auto cylinder = makeGeometry(Cylinder{{{-2, 0, 0}}, {{2, 0, 0}}, 1});
    expectSamePoints(*placed(cube, placement), 0.125);
    expectSamePoints(*placed(cylinder, placement), 0.125);
    if (angle == 30)
      expectSamePoints(*placed(differenceOf<3>({cube, cylinder}), placement), 0.25, {"cubic"});
  }
}

// On the surface only: what seams between fluids are looked for with.
TEST(FillRows, PointsOnTheSurface) {
  const auto cube = boxOf<3>({{-1, -1, -1}}, {{1, 1, 1}});
  const double roundOff = surfaceRoundOff * 0.25;
  const auto points = latticePoints(Lattice<3>("cubic", 0.25), cube->bounds().grown(1), *cube,
                                    {-roundOff, roundOff});
  EXPECT_EQ(points.size(), 9u * 9 * 9 - 7 * 7 * 7);
  for (const Vec<3>& x : points) EXPECT_EQ(cube->signedDistance(x), 0);
}

TEST(FillRows, PlacesOfPoints) {
  const auto part = makeSurfaceMesh(starShapedMesh(9, roughRadius), "part");
  const double spacing = 0.1;
  std::vector<Vec<3>> points = latticePoints(Lattice<3>("hcp", spacing), part->bounds().grown(0.2));
  for (std::size_t k = 0; k < points.size(); k += 7) points[k] *= 1.01;  // out of the rows
  for (const double near : {1e-7, 0.05}) {
    const std::vector<PointPlace> places = placesOf<3>(*part, points, spacing, near);
    ASSERT_EQ(places.size(), points.size());
    const std::vector<double> distances = signedDistances<3>(*part, points);
    std::size_t nUnknown = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (places[k] == PointPlace::unknown) ++nUnknown;
      if (places[k] == PointPlace::unknown) continue;
      ASSERT_GT(places[k] == PointPlace::inside ? -distances[k] : distances[k], near);
    }
    // `near` 1e-7 should find nobody by chance; within .05 (asked as .1) lies less than half.
    EXPECT_LT(nUnknown, near > 0.01 ? points.size() / 2 : 10u);
  }
}

/// A box from -1 to 1 as twelve triangles.
TriangleSoup cubeMesh() {
  TriangleSoup soup;
  for (int corner = 0; corner < 8; ++corner)
    soup.points.push_back({{corner & 1 ? 1. : -1, corner & 2 ? 1. : -1, corner & 4 ? 1. : -1}});
  for (const auto& [a, b, c, d] : std::initializer_list<std::array<std::size_t, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  }
  return soup;
}

TEST(FillRows, Meshes) {
  const auto cube = makeSurfaceMesh(cubeMesh(), "cube");
  expectSamePoints(*cube, 0.125);
  for (const double angle : {30., 45., 90.}) {
    Placement<3> placement;
    placement.rotate(angle, {0, 0, 1});
    expectSamePoints(*placed(cube, placement), 0.125);
  }
  for (const int frequency : {1, 3, 20})
    expectSamePoints(*makeSurfaceMesh(starShapedMesh(frequency, roughRadius), "part"), 0.09);
  // An icosahedron has edges along the axes and corners in the planes x = 0, y = 0, z = 0.
  expectSamePoints(*makeSurfaceMesh(starShapedMesh(2, [](const Vec<3>&) { return 1; }), "sphere"),
                   0.125);
  expectSamePoints(*differenceOf<3>({cube, makeGeometry(Ball<3>{{}, 0.8})}), 0.25, {"cubic"});
}

}  // namespace
}  // namespace plenum
