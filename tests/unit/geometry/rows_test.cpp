// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/meshes.hpp"
#include "geometry/box_shape.hpp"
#include "geometry/extrusion.hpp"
#include "geometry/placement.hpp"
#include "geometry/round_shapes.hpp"
#include "geometry/set_operation.hpp"
#include "geometry/surface_mesh.hpp"
#include "particles/errors.hpp"
#include "probe.hpp"

namespace plenum::test {
namespace {

constexpr double near = 1e-6;  // of sizes about 1 m

struct Share {
  std::size_t sure = 0;
  std::size_t unknown = 0;
};

/// Every point that the classifier is sure of is as far on that side as it says; returns how many
/// are. All points of all rows have a place.
template <int Dim>
void expectSure(const Geometry<Dim>& geometry, const std::vector<Row<Dim>>& rows,
                const Vec<Dim>& step, Share& share) {
  RowRuns runs;
  geometry.rowClassifier(step, near)->classify(rows, runs);
  ASSERT_EQ(runs.nRows(), rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::int64_t i = 0;
    for (const RowRun& run : runs[r]) {
      ASSERT_GT(run.end, i);
      for (; i < run.end; ++i) {
        const Vec<Dim> x = rows[r].first + static_cast<double>(i) * step;
        ++(run.place == PointPlace::unknown ? share.unknown : share.sure);
        if (run.place == PointPlace::unknown) continue;
        const double distance = geometry.signedDistance(x);
        ASSERT_GT(run.place == PointPlace::inside ? -distance : distance, near * (1 - 1e-6))
            << geometry.describe() << " at " << testing::PrintToString(x.components);
      }
    }
    ASSERT_EQ(i, rows[r].count);
  }
}

/// Rows along random directions and along the axes, through a box of 4 m.
template <int Dim>
Share expectSureOnRandomRows(const Geometry<Dim>& geometry, int nDirections, unsigned seed = 1) {
  Random<Dim> random(seed);
  Share share;
  const Box<Dim> box{Vec<Dim>::filled(-2), Vec<Dim>::filled(2), {}};
  for (int k = 0; k < nDirections; ++k) {
    const Vec<Dim> direction = k < Dim ? unitVector<Dim>(k) : random.direction();
    const Vec<Dim> step = random.number(0.03, 0.2) * direction;
    std::vector<Row<Dim>> rows{{random.inBox(box), 0}};  // a row without points, too
    for (int r = 0; r < 20; ++r) rows.push_back({random.inBox(box) - 10. * step, 30});
    expectSure(geometry, rows, step, share);
  }
  return share;
}

template <int Dim>
GeometryPtr<Dim> randomShape(Random<Dim>& random, int depth);

template <int Dim>
GeometryPtr<Dim> randomSimple(Random<Dim>& random) {
  const Vec<Dim> center = 0.5 * random.direction();
  const double size = random.number(0.3, 1);
  const auto kind = static_cast<int>(random.number(0, 4));
  if constexpr (Dim == 3)
    if (kind == 0) return makeGeometry(Cylinder{center, center + random.direction(), size});
  if constexpr (Dim == 2)
    if (kind == 0) return makeGeometry(Annulus{center, 0.5 * size, size});
  if (kind == 1) return makeGeometry(Ball<Dim>{center, size});
  if (kind == 2) return makeGeometry(HalfSpace<Dim>{center, random.direction()});
  BoxShape<Dim> box{{center, center, {}}};
  for (int a = 0; a < Dim; ++a) {
    box.box.lower[a] -= random.number(0.2, 0.8);
    box.box.upper[a] += random.number(0.2, 0.8);
  }
  return makeGeometry(box);
}

template <int Dim>
GeometryPtr<Dim> randomShape(Random<Dim>& random, int depth) {
  GeometryPtr<Dim> shape = randomSimple(random);
  if (depth > 0) {
    const auto operation = static_cast<int>(random.number(0, 3));
    const std::vector<GeometryPtr<Dim>> parts{randomShape(random, depth - 1), shape};
    try {
      shape = operation == 0   ? unionOf<Dim>(parts)
              : operation == 1 ? intersectionOf<Dim>(parts)
                               : differenceOf<Dim>(parts);
    } catch (const InputError&) {  // empty, or all of space
    }
  }
  Placement<Dim> placement;
  placement.scale = random.number(0.8, 1.25);
  placement.rotate(random.number(0, 360), {0.3, random.number(0, 1), 0.8});
  placement.translation = 0.2 * random.direction();
  return placed(shape, placement);
}

TEST(Rows, SimpleShapes) {
  Random<2> plane(3);
  Random<3> space(4);
  for (int k = 0; k < 200; ++k) {
    expectSureOnRandomRows<2>(*randomSimple(plane), 5);
    // Chords leave out no point that is further than `near` from a convex shape's surface, but a
    // few at edges: unknown is less than one in a thousand.
    const Share share = expectSureOnRandomRows<3>(*randomSimple(space), 6);
    EXPECT_LE(share.unknown * 1000, share.sure);
  }
}

TEST(Rows, Extrusions) {
  Random<2> plane(7);
  Share all;
  for (int k = 0; k < 100; ++k) {
    const double lower = plane.number(-1, 0);
    const auto solid = extruded(randomSimple(plane), lower, lower + plane.number(0.1, 1));
    const Share share = expectSureOnRandomRows<3>(*solid, 6);  // three of them along the axes
    EXPECT_LE(share.unknown * 1000, share.sure);
    // Rows almost along z, the direction of extrusion.
    for (const double slope : {1e-17, 1e-12, 1e-8, 1e-5, 0.9e-3, 1.1e-3}) {
      std::vector<Row<3>> rows;
      for (int j = -12; j <= 12; ++j) rows.push_back({{{0.1 * j, 0.05 * j, -1.5}}, 60});
      expectSure(*solid, rows, Vec<3>{{0.05 * slope, 0, 0.05}}, all);
    }
  }
  EXPECT_LE(all.unknown * 1000, all.sure);
}

TEST(Rows, NestedAndTurnedShapes) {
  Random<2> plane(5);
  Random<3> space(6);
  for (int k = 0; k < 25; ++k) {
    expectSureOnRandomRows<2>(*randomShape(plane, 1 + k % 2), 3);
    expectSureOnRandomRows<3>(*randomShape(space, 1), 2);
  }
}

TEST(Rows, CylindersAlmostAlongTheRows) {
  const auto cylinder = makeGeometry(Cylinder{{{-0.9, 0, 0}}, {{0.9, 0, 0}}, 0.5});
  Share share;
  for (const double slope : {0., 1e-17, 1e-12, 1e-8, 1e-5, 0.9e-3, 1.1e-3}) {
    std::vector<Row<3>> rows;
    for (int j = -12; j <= 12; ++j) rows.push_back({{{-1.5, 0.05 * j, 0.01}}, 60});
    expectSure(*cylinder, rows, Vec<3>{{0.05, 0.05 * slope, 0}}, share);
  }
  // Of 1500 points two rows at the side have 37 each, the caps two in 19 rows.
  EXPECT_LE(share.unknown * 13, share.sure + share.unknown);
}

/// A cube from -1 to 1 whose faces are parted in n x n squares, each in two.
TriangleSoup gridCube(int n) {
  TriangleSoup soup;
  const auto add = [&](int axis, double side, int i, int j) {
    const auto corner = [&](int p, int q) {
      Vec<3> x;
      x[axis] = side;
      x[(axis + 1) % 3] = -1 + 2. * p / n;
      x[(axis + 2) % 3] = -1 + 2. * q / n;
      soup.points.push_back(x);
      return soup.points.size() - 1;
    };
    const std::size_t a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                      d = corner(i, j + 1);
    soup.triangles.push_back({a, side > 0 ? b : c, side > 0 ? c : b});
    soup.triangles.push_back({a, side > 0 ? c : d, side > 0 ? d : c});
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1., 1.})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) add(axis, side, i, j);
  return soup;
}

double rough(const Vec<3>& direction) { return 0.2 + roughRadius(direction); }

TEST(Rows, Meshes) {
  for (const TriangleSoup& soup :
       {gridCube(1), gridCube(3), starShapedMesh(1, rough), starShapedMesh(12, rough)}) {
    const auto mesh = makeSurfaceMesh(soup, "mesh");
    const Share share = expectSureOnRandomRows<3>(*mesh, 40);
    EXPECT_LE(share.unknown * 1000, share.sure);  // surfaces are met within 1e-6 m
    Placement<3> placement;
    placement.scale = 0.7;
    placement.rotate(30, {0, 0, 1});
    expectSureOnRandomRows<3>(*placed(mesh, placement), 10);
  }
}

// Rows exactly along edges, through corners, in faces, and along diagonals of faces.
TEST(Rows, MeshesAlignedWithRows) {
  for (const int n : {1, 2, 4}) {
    const auto mesh = makeSurfaceMesh(gridCube(n), "cube");
    for (const Vec<3>& step : {Vec<3>{{0.125, 0, 0}},
                               {{0, -0.125, 0}},
                               {{0.125, 0.125, 0}},
                               {{0, 0.125, -0.125}},
                               {{0.125, 0.125, 0.125}}}) {
      std::vector<Row<3>> rows;
      for (int i = -10; i <= 10; ++i)
        for (int j = -10; j <= 10; ++j)
          rows.push_back({{{0.125 * i - 16 * step[0], 0.125 * j - 16 * step[1],
                            0.125 * (i + j) / 2 - 16 * step[2]}},
                          33});
      Share share;
      expectSure(*mesh, rows, step, share);
      EXPECT_LT(share.unknown * 8, share.sure);  // the points of faces, 1 of 8 layers each
    }
  }
}

// The needles of a fan are thinner than `near` at their tip, and some are parallel to the rows.
TEST(Rows, MeshesWithNeedles) {
  TriangleSoup soup;
  const int n = 2000;
  for (const double z : {-0.5, 0.5}) {
    soup.points.push_back({{1, 0, z}});
    for (int k = 1; k < n; ++k) {
      const double angle = 2 * 3.14159265358979 * k / n;
      soup.points.push_back({{std::cos(angle), std::sin(angle), z}});
    }
  }
  const std::size_t m = n;
  for (std::size_t k = 2; k < m; ++k) {
    soup.triangles.push_back({0, k, k - 1});
    soup.triangles.push_back({m, m + k - 1, m + k});
  }
  for (std::size_t k = 0; k < m; ++k) {
    const std::size_t next = (k + 1) % m;
    soup.triangles.push_back({k, next, m + next});
    soup.triangles.push_back({k, m + next, m + k});
  }
  const auto mesh = makeSurfaceMesh(soup, "fan");
  Share share = expectSureOnRandomRows<3>(*mesh, 12);
  EXPECT_LE(share.unknown * 1000, share.sure);
  std::vector<Row<3>> rows;
  for (int k = -12; k <= 12; ++k) rows.push_back({{{-1.5, 0.1 * k, 0.5}}, 60});  // in the fan
  expectSure(*mesh, rows, Vec<3>{{0.05, 0, 0}}, share);
}

// On the face that two boxes share a point is inside the union: unknown to both, asked exactly.
TEST(Rows, SeamsAreUnknown) {
  const auto left = makeGeometry(BoxShape<3>{{{{-1, -1, -1}}, {{0, 1, 1}}, {}}});
  const auto right = makeGeometry(BoxShape<3>{{{{0, -1, -1}}, {{1, 1, 1}}, {}}});
  const auto both = unionOf<3>({left, right});
  const std::vector<Row<3>> rows{{{{-1.25, 0, 0}}, 6}};  // -1.25, -.75, -.25, .25, ...
  const std::vector<Row<3>> seam{{{{-1.5, 0, 0}}, 7}};   // -1.5, -1, -.5, 0, ...
  RowRuns runs;
  const auto classifier = both->rowClassifier({{0.5, 0, 0}}, near);
  classifier->classify(rows, runs);
  const auto places = [&] {
    std::vector<std::pair<std::int64_t, PointPlace>> all;
    for (const RowRun& run : runs[0]) all.emplace_back(run.end, run.place);
    return all;
  };
  using Expected = std::vector<std::pair<std::int64_t, PointPlace>>;
  EXPECT_EQ(
      places(),
      (Expected{{1, PointPlace::outside}, {5, PointPlace::inside}, {6, PointPlace::outside}}));
  classifier->classify(seam, runs);
  EXPECT_EQ(places(), (Expected{{1, PointPlace::outside},
                                {2, PointPlace::unknown},
                                {3, PointPlace::inside},
                                {4, PointPlace::unknown},
                                {5, PointPlace::inside},
                                {6, PointPlace::unknown},
                                {7, PointPlace::outside}}));
}

}  // namespace
}  // namespace plenum::test
