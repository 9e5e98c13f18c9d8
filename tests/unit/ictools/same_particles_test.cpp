// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same part from formulas and from every kind of file gives the same particles, apart from
// those within the files' tolerance of the surface.
#include "tests/support/named_region.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

namespace plenum {
namespace {

constexpr double pi = std::numbers::pi;

/// Positions of fluid (true) or walls in an order that does not depend on how they were found.
template <int Dim>
std::vector<Vec<Dim>> sorted(const Scene<Dim>& scene, bool fluid) {
  const auto all = scene.particles[field::position];
  const auto n = static_cast<std::ptrdiff_t>(scene.particles.nFluid());
  std::vector<Vec<Dim>> points(fluid ? all.begin() : all.begin() + n,
                               fluid ? all.begin() + n : all.end());
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.components < b.components; });
  return points;
}

/// Expects that all particles that only one of the sets has lie within `tolerance` of a place where
/// fluid or wall begins or ends: depth 0 or `thickness`. Returns how many there are.
template <int Dim>
std::size_t expectSame(const Scene<Dim>& scene, const Scene<Dim>& exact,
                       const Geometry<Dim>& geometry, double tolerance, double thickness) {
  std::size_t nDifferent = 0;
  for (const bool fluid : {true, false}) {
    const auto a = sorted(scene, fluid), b = sorted(exact, fluid);
    std::vector<Vec<Dim>> different;
    std::set_symmetric_difference(
        a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(different),
        [](const auto& x, const auto& y) { return x.components < y.components; });
    for (const Vec<Dim>& x : different) {
      const double distance = geometry.signedDistance(x);
      EXPECT_LE(std::min(std::abs(distance), std::abs(distance - thickness)), tolerance);
    }
    nDifferent += different.size();
  }
  return nDifferent;
}

/// A case whose region "part" is `part` and that has walls all around it.
std::string caseOf(int dimension, double spacing, const std::string& part) {
  return fmt::format(R"(
dimension = {}
spacing = {}
[geometry]
shaft = {{ disk = {{ center = [0, 0], radius = 0.04 }} }}
housing = {{ disk = {{ center = [0, 0], radius = 0.10 }} }}
block = {{ box = {{ lower = [-0.5, -0.5, -0.25], upper = [0.5, 0.5, 0.25] }} }}
bore = {{ cylinder = {{ from = [0, 0, -1], to = [0, 0, 1], radius = 0.25 }} }}
part = {}
[[fluid]]
region = "part"
lattice_origin = [{}]
mass = "exact"
[[wall]]
outside = "part"
)",
                     dimension, spacing, part, dimension == 2 ? "0, 0" : "0.01, 0.02, 0.012");
}

/// Only the shapes of this dimension.
std::string only(int dimension, std::string text) {
  for (const char* name : {"shaft", "housing", "block", "bore"}) {
    const bool isPlane = name[0] == 's' || name[0] == 'h';
    if (isPlane == (dimension == 2)) continue;
    const std::size_t begin = text.find(std::string(name) + " = ");
    text.erase(begin, text.find('\n', begin) + 1 - begin);
  }
  return text;
}

/// `surface`: measure of the part's boundary [m^(d-1)].
template <int Dim>
void expectSameFromFiles(double spacing, const std::string& formula,
                         const std::vector<std::string>& files, double tolerance, double surface) {
  const std::string exactText = only(Dim, caseOf(Dim, spacing, formula));
  const Scene<Dim> exact = test::sceneOf<Dim>(exactText);
  const CaseNode root = CaseNode::parse(exactText, "test.toml");
  const auto regions = GeometrySet<Dim>::read(*root.find("geometry"), ".");
  const GeometryPtr<Dim> geometry = test::regionNamed(regions, "part");
  for (const std::string& file : files) {
    const std::string part = fmt::format("{{ file = \"{}\", tolerance = {} }}", file, tolerance);
    const Scene<Dim> scene = test::sceneOf<Dim>(only(Dim, caseOf(Dim, spacing, part)));
    const std::size_t nDifferent =
        expectSame<Dim>(scene, exact, *geometry, tolerance, exact.info.walls[0].thickness);
    std::cout << fmt::format("{}: {} fluid and {} wall particles, {} of them not the same\n",
                             file.substr(file.rfind('/') + 1), scene.particles.nFluid(),
                             scene.particles.nWalls(), nDifferent);
    // A lattice has so many points within the tolerance of the surface: one that changes sides is
    // missing in the fluid and new in the wall or the other way round; and as many may lie at the
    // end of the layers.
    const double cell = Dim == 2 ? std::sqrt(3.0) / 2 : 1 / std::sqrt(2.0);  // hexagonal, hcp
    const double inStrip = 2 * tolerance * surface / (cell * std::pow(spacing, Dim));
    EXPECT_LE(static_cast<double>(nDifferent), 3 * inStrip);
    double mass = 0, exactMass = 0;
    for (std::size_t i = 0; i < scene.particles.nFluid(); ++i)
      mass += scene.particles[field::mass][i];
    for (std::size_t i = 0; i < exact.particles.nFluid(); ++i)
      exactMass += exact.particles[field::mass][i];
    // Masses are exact, so they differ by the volumes: a strip of the tolerance along the surface,
    // whose measure over the part's is below 34 /m (annulus: 2/(0.10 - 0.04)).
    EXPECT_NEAR(mass / exactMass, 1, 34 * tolerance);
  }
}

TEST(SameParticles, AnnulusFromFormulasPolygonGeoAndStep) {
  const std::string built = PLENUM_CAD_FILES, scripts = PLENUM_CAD_SCRIPTS;
  expectSameFromFiles<2>(
      0.005, "{ difference = [\"housing\", \"shaft\"] }",
      {built + "/annulus.wkt", scripts + "/annulus.geo", built + "/annulus.step"}, 1e-4,
      2 * pi * (0.04 + 0.10));
}

TEST(SameParticles, BlockMinusCylinderFromFormulasStlAndStep) {
  const std::string built = PLENUM_CAD_FILES, scripts = PLENUM_CAD_SCRIPTS;
  expectSameFromFiles<3>(0.05, "{ difference = [\"block\", \"bore\"] }",
                         {built + "/box_minus_cylinder.stl", built + "/box_minus_cylinder.step",
                          scripts + "/box_minus_cylinder.geo"},
                         2e-4, 2 * (1 - pi / 16) + 4 * 0.5 + 2 * pi * 0.25 * 0.5);
}

}  // namespace
}  // namespace plenum
