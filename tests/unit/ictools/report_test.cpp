// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/report.hpp"

#include "tests/support/temporary_folder.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace plenum {
namespace {

const PlaceFigures& at(const Report& report, Place place) {
  return report.places[static_cast<std::size_t>(place)];
}

/// Edges of the unit cell and points in it, for d_ref = 1.
struct Cell {
  const char* lattice;
  std::vector<double> edges;
  double volume;  ///< of a particle
};

const Cell hexagonal{"hexagonal", {1, std::sqrt(3.0)}, std::sqrt(0.75)};
const Cell cubic{"cubic", {1, 1, 1}, 1};
const Cell hcp{"hcp", {1, std::sqrt(3.0), std::sqrt(8.0 / 3)}, std::sqrt(0.5)};
const Cell fcc{"fcc", {std::sqrt(2.0), std::sqrt(2.0), std::sqrt(2.0)}, std::sqrt(0.5)};

/// A periodic box of whole cells, at least `size` along each axis, with smoothing length `h`.
std::string latticeCase(const Cell& cell, const std::string& kernel, double h, double size) {
  std::string upper, lower, axes;
  for (std::size_t a = 0; a < cell.edges.size(); ++a) {
    upper += fmt::format("{:.17g}, ", cell.edges[a] * std::ceil(size / cell.edges[a]));
    lower += "0, ";
    axes += fmt::format("\"{}\", ", "xyz"[a]);
  }
  return fmt::format(
      "dimension = {}\nspacing = 1\n[domain]\nlower = [{}]\nupper = [{}]\nperiodic = [{}]\n"
      "[[fluid]]\nlattice = \"{}\"\n[solver]\nkernel = \"{}\"\nsmoothing_length = {:.17g}\n",
      cell.edges.size(), lower, upper, axes, cell.lattice, kernel, h);
}

template <int Dim>
double biasOf(const Cell& cell, const std::string& kernel, double h) {
  const auto scene = test::sceneOf<Dim>(latticeCase(cell, kernel, h, 4.2 * h));
  const Report report = reportOn(scene);
  // A perfect lattice: nobody at a surface, all alike to the round-off of double sums.
  EXPECT_EQ(at(report, Place::inside).n, report.nFluid);
  EXPECT_LT(at(report, Place::inside).scatter, 1e-7);
  EXPECT_LT(at(report, Place::inside).largestGradient, 1e-10);
  return 100 * at(report, Place::inside).bias;
}

/// By h over dx = (cell volume)^(1/d), in per cent, to the digits of the table.
TEST(Report, LatticeBiasOfTheTable) {
  const double hOverDx[] = {1.2, 1.3, 1.5, 2.0};
  const auto check = [&]<int Dim>(std::integral_constant<int, Dim>, const Cell& cell,
                                  const char* kernel, const double(&expected)[4]) {
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(biasOf<Dim>(cell, kernel, hOverDx[k] * std::pow(cell.volume, 1.0 / Dim)),
                  expected[k], 0.0006)  // digits given, rounded
          << cell.lattice << " " << kernel << " " << hOverDx[k];
  };
  const std::integral_constant<int, 2> two;
  const std::integral_constant<int, 3> three;
  check(three, cubic, "cubic_spline", {.081, -.274, .179, .008});
  check(three, cubic, "wendland_c2", {1.746, .950, .314, .055});
  check(three, hcp, "wendland_c2", {1.181, .645, .367, .060});
  check(two, hexagonal, "wendland_c2", {1.486, .884, .539, .129});
}

/// The same by h over d_ref.
TEST(Report, LatticeBiasOfTheTableByNearestNeighbours) {
  const double h[] = {1.2, 1.3, 1.5, 2.0};
  const double of2D[] = {.925, .671, .368, .081}, of3D[] = {.545, .416, .147, .029};
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(biasOf<2>(hexagonal, "wendland_c2", h[k]), of2D[k], 0.0006) << h[k];
    EXPECT_NEAR(biasOf<3>(hcp, "wendland_c2", h[k]), of3D[k], 0.0006) << h[k];
  }
}

/// By neighbours in the support, hcp.
TEST(Report, DensityBiasByNumberOfNeighbours) {
  struct Row {
    const char* kernel;
    double bias[5], digit;  ///< [%], half of the last digit given
  };
  const Row rows[] = {{"cubic_spline", {-.06, -.04, .42, .01, .02}, .006},
                      {"wendland_c2", {4.2, .89, .44, .10, .03}, .06},
                      {"convex", {12.8, 4.4, 2.7, 1.0, .40}, .06}};
  const double neighbours[] = {32, 64, 100, 200, 400};
  for (const Row& row : rows)
    for (int k = 0; k < 5; ++k) {
      const double h = 0.5 * std::cbrt(3 * neighbours[k] * hcp.volume / (4 * kernel::pi));
      EXPECT_NEAR(biasOf<3>(hcp, row.kernel, h), row.bias[k], row.digit)
          << row.kernel << " " << neighbours[k];
    }
}

TEST(Report, BondOrder) {
  const auto order = [](const auto& scene) { return reportOn(scene).bondOrder; };
  // Known values of perfect lattices.
  EXPECT_NEAR(order(test::sceneOf<2>(latticeCase(hexagonal, "wendland_c2", 1.5, 8))), 1, 1e-9);
  EXPECT_NEAR(order(test::sceneOf<3>(latticeCase(hcp, "wendland_c2", 1.2, 6))), 0.48476, 1e-5);
  EXPECT_NEAR(order(test::sceneOf<3>(latticeCase(fcc, "wendland_c2", 1.2, 6))), 0.57452, 1e-5);
}

const std::string column = R"(
dimension = 2
spacing = 0.02
[domain]
lower = [0, 0]
upper = [0.4, 1]
periodic = ["x"]
[geometry]
column = { box = { lower = [0, 0], upper = [0.4, 0.5] } }
ground = { half_space = { point = [0, 0], normal = [0, 1] } }
[[fluid]]
region = "column"
[[wall]]
region = "ground"
)";

TEST(Report, TellsWallsFromFreeSurfaces) {
  const Scene<2> scene = test::sceneOf<2>(column);
  const Report report = reportOn(scene);
  // 20 particles a row (the box is 20 spacings wide); the support is 3 spacings, rows are .866
  // apart and the surfaces lie half a row from the first. So four rows have a wall within the
  // support minus one (the wall's first row stands one row away), and four a free one and itself.
  const double row = std::sqrt(0.75);
  const auto rowsAtWall = static_cast<std::size_t>(std::floor(3 / row));
  const auto rowsAtSurface = rowsAtWall + 1;
  EXPECT_EQ(at(report, Place::wall).n, 20 * rowsAtWall);
  EXPECT_EQ(at(report, Place::freeSurface).n, 20 * rowsAtSurface);
  EXPECT_EQ(at(report, Place::inside).n, report.nFluid - 20 * (rowsAtWall + rowsAtSurface));
  EXPECT_LT(at(report, Place::freeSurface).kernelSum, 0.95);
  EXPECT_GT(at(report, Place::freeSurface).largestGradient, 0.2);
  // Stretched by up to 1 % to the periodic box, the lattice goes on behind the wall.
  EXPECT_LT(at(report, Place::wall).largestGradient, 0.01);
  ASSERT_EQ(report.walls.size(), 1u);
  EXPECT_NEAR(report.walls[0].thickness, 0.06, 1e-9);
  EXPECT_NEAR(report.walls[0].support, 0.06, 1e-12);
}

TEST(Report, CountsOverlapsAndIsolatedParticles) {
  Scene<2> scene = test::sceneOf<2>(column);
  const auto position = scene.particles[field::position];
  position[0] = position[1] + Vec<2>{{0.002, 0}};
  position[2] = {{0.2, 0.9}};
  const Report report = reportOn(scene);
  EXPECT_EQ(report.nOverlaps, 2u);
  EXPECT_EQ(report.nIsolated, 1u);
  EXPECT_NEAR(report.nearest.least, 0.1, 1e-9);
}

TEST(Report, WritesJsonAndPicture) {
  const test::TemporaryFolder folder;
  const Report report = reportOn(test::sceneOf<2>(column));
  const auto parsed = nlohmann::json::parse(json(report));
  EXPECT_EQ(parsed["fluid_particles"], report.nFluid);
  EXPECT_EQ(parsed["places"]["inside"]["density_bias"].get<double>(),
            at(report, Place::inside).bias);
  EXPECT_EQ(parsed["pairing"]["verdict"], "safe");
  drawReport(folder.path() / "report.png", report);
  EXPECT_GT(std::filesystem::file_size(folder.path() / "report.png"), 1000u);
  const std::string text = printed(report);
  EXPECT_NE(text.find("at free surfaces"), std::string::npos) << text;
}

}  // namespace
}  // namespace plenum
