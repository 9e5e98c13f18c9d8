// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/check.hpp"
#include "ictools/report.hpp"
#include "particles/memory.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/threads.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <numbers>
#include <numeric>

namespace plenum {
namespace {

using std::numbers::pi;

/// Scatter of the kernel sum with each particle's own smoothing length: what is asked of refined
/// sets. Reached are .2 to .3 %.
constexpr double mostScatter = 0.01;

/// The annulus of `shaftCase` with walls of `method`, refined near the shaft.
std::string annulus(double ratio, const std::string& method = "conformal",
                    const std::string& more = "") {
  return fmt::format(R"(
dimension = 2
spacing = 0.005
[geometry]
shaft = {{ disk = {{ center = [0, 0], radius = 0.04 }} }}
housing = {{ disk = {{ center = [0, 0], radius = 0.10 }} }}
gap = {{ difference = ["housing", "shaft"] }}
[[refine]]
near = "shaft"
spacing = {}
[[fluid]]
region = "gap"
mass = "exact"
density = 3
[[wall]]
region = "shaft"
method = "{}"
[[wall]]
outside = "housing"
method = "{}"
[relax]
{})",
                     ratio, method, method, more);
}

/// s [m] at the distance x [m] from the shaft, with the default growth.
double targetAt(double ratio, double x) { return std::min(0.005, ratio * 0.005 + 0.1 * x); }

/// Particles between two radii by the integral of 1/V, V = sqrt(3)/2 s^2.
double particlesBetween(double ratio, double inner, double outer) {
  constexpr int n = 10000;  // midpoints: to the eighth digit
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    const double r = inner + (k + 0.5) / n * (outer - inner), s = targetAt(ratio, r - 0.04);
    sum += 2 * pi * r / (std::sqrt(0.75) * s * s);
  }
  return sum * (outer - inner) / n;
}

double relaxedScatter(const auto& scene) {
  const std::map<std::string, double> figures{scene.info.quality.begin(), scene.info.quality.end()};
  return figures.at("relaxation: scatter of the kernel sum");
}

double massOf(const auto& scene) {
  const auto mass = scene.particles[field::mass].first(scene.particles.nFluid());
  return std::accumulate(mass.begin(), mass.end(), 0.0);
}

TEST(Refinement, NearASurface) {
  for (const double ratio : {0.5, 0.25}) {
    SCOPED_TRACE(ratio);
    const Scene<2> scene = test::sceneOf<2>(annulus(ratio));
    const auto& p = scene.particles;
    EXPECT_LE(relaxedScatter(scene), mostScatter);
    EXPECT_NEAR(massOf(scene) / (3 * pi * (0.01 - 0.0016)), 1, 1e-12);  // sums of round-off
    const double wanted = particlesBetween(ratio, 0.04, 0.1);
    // Cells at the rims are in or out as a whole; scaled by the exact volume.
    EXPECT_NEAR(static_cast<double>(p.nFluid()) / wanted, 1, 0.01);
    for (std::size_t i = 0; i < p.nFluid(); ++i) {
      const double r = norm(p[field::position][i]);
      EXPECT_GT(r, 0.04);
      EXPECT_LT(r, 0.1);
      const double s = targetAt(ratio, r - 0.04);
      EXPECT_NEAR(p[field::smoothingLength][i], 1.5 * s, 1e-12);
    }
  }
}

TEST(Refinement, SpacingFollowsTheTargetAtEachDistance) {
  for (const double ratio : {0.5, 0.25}) {
    const Scene<2> scene = test::sceneOf<2>(annulus(ratio));
    for (int ring = 0; ring < 6; ++ring) {  // two d_ref wide
      const double inner = 0.04 + 0.01 * ring, outer = inner + 0.01;
      double n = 0;
      for (std::size_t i = 0; i < scene.particles.nFluid(); ++i) {
        const double r = norm(scene.particles[field::position][i]);
        n += r >= inner && r < outer;
      }
      // Rows of particles along the rims of a ring are counted in it or in the next: of its two to
      // eight rows a fifth of one is 5 % of the number, and half of that of the spacing.
      EXPECT_NEAR(std::sqrt(particlesBetween(ratio, inner, outer) / n), 1, 0.04)
          << ratio << " ring " << ring;
    }
  }
}

TEST(Refinement, WallsFitTheFluidBeforeThem) {
  for (const char* method : {"lattice", "conformal"}) {
    const Scene<2> scene = test::sceneOf<2>(annulus(0.25, method));
    const auto& p = scene.particles;
    const double finest = 0.25 * 0.005;
    EXPECT_NEAR(scene.info.walls[0].thickness, 3 * finest, 1e-12);
    EXPECT_NEAR(scene.info.walls[1].thickness, 3 * 0.005, 1e-12);
    for (std::size_t w = 0; w < p.nWalls(); ++w) {
      const std::size_t i = p.nFluid() + w;
      const bool isShaft = p[field::wall][w] == 0;
      EXPECT_NEAR(p[field::smoothingLength][i], 1.5 * (isShaft ? finest : 0.005), 1e-12);
    }
    for (const WallLayers& wall : reportOn(scene).walls)
      EXPECT_GE(wall.thickness, wall.support) << method << " " << wall.name;
    EXPECT_LE(relaxedScatter(scene), mostScatter) << method;
  }
}

const std::string ball = R"(
dimension = 3
spacing = 0.06
[geometry]
ball = { ball = { center = [1, 0, 0], radius = 0.5 } }
core = { ball = { center = [1, 0, 0], radius = 0.15 } }
[[refine]]
inside = "core"
spacing = 0.5
[[fluid]]
region = "ball"
mass = "exact"
[solver]
smoothing_length = 1.1053
)";
const std::string ballWall = "[[wall]]\noutside = \"ball\"\nmethod = \"conformal\"\n";

TEST(Refinement, InsideARegion) {
  const Scene<3> scene = test::sceneOf<3>(ball + "[relax]\n" + ballWall);
  const auto& p = scene.particles;
  EXPECT_LE(relaxedScatter(scene), mostScatter);
  const double volume = 4 * pi / 3 * 0.125;
  EXPECT_NEAR(massOf(scene) / volume, 1, 1e-12);
  double wanted = 0, inCore = 0;
  constexpr int n = 10000;
  for (int k = 0; k < n; ++k) {
    const double r = (k + 0.5) / n * 0.5;
    const double s = std::min(0.06, 0.03 + 0.1 * std::max(0.0, r - 0.15));
    wanted += 4 * pi * r * r / (s * s * s / std::sqrt(2)) * 0.5 / n;
  }
  EXPECT_NEAR(static_cast<double>(p.nFluid()) / wanted, 1, 0.01);
  for (std::size_t i = 0; i < p.nFluid(); ++i) {
    const double r = norm(p[field::position][i] - Vec<3>{{1, 0, 0}});
    EXPECT_LT(r, 0.5);
    inCore += r < 0.15;
  }
  // 4 pi/3 .15^3 over .03^3/sqrt(2) are 740 particles, those of a row at the rim about 150: a fifth
  // of these.
  const double coreVolume = 4 * pi / 3 * std::pow(0.15, 3);
  EXPECT_NEAR(inCore * std::pow(0.03, 3) / std::sqrt(2) / coreVolume, 1, 0.04);
}

TEST(Refinement, WorksWithEachMethodOfRelaxation) {
  // The set starts at 3.9 %; measured .2 %, .7 % and 2.2 %. Voronoi moves whose pushes do not
  // cancel where smoothing lengths differ stay where they start.
  for (const auto& [method, bound] :
       {std::pair{"packing", 0.01}, {"wvt", 0.01}, {"lloyd", 0.025}}) {
    const std::string relax = fmt::format("method = \"{}\"\nmax_iterations = 200", method);
    EXPECT_LE(relaxedScatter(test::sceneOf<2>(annulus(0.5, "conformal", relax))), bound) << method;
  }
}

TEST(Refinement, StartsCloseToWhatIsWanted) {
  // Random places scatter by 20 to 30 %.
  const std::string start = annulus(0.25, "conformal", "max_iterations = 1");
  const double middles = relaxedScatter(test::sceneOf<2>(start));
  EXPECT_LE(middles, 0.06);
  std::string random = start;
  random.insert(random.find("mass ="), "lattice = \"random\"\n");
  EXPECT_GT(relaxedScatter(test::sceneOf<2>(random)), 1.5 * middles);
}

TEST(Refinement, RandomPlacesAreAllDifferent) {
  const std::string text = R"(
dimension = 3
spacing = 0.1
[geometry]
ball = { ball = { center = [0, 0, 0], radius = 0.5 } }
[[fluid]]
region = "ball"
lattice = "random"
[[refine]]
near = "ball"
spacing = 0.3
)";
  const Scene<3> scene = test::sceneOf<3>(text);
  const auto position = scene.particles[field::position];
  std::vector<Vec<3>> sorted(position.begin(), position.end());
  std::ranges::sort(sorted, {}, [](const Vec<3>& x) { return x.components; });
  const auto twin =
      std::ranges::adjacent_find(sorted, {}, [](const Vec<3>& x) { return x.components; });
  EXPECT_GT(sorted.size(), 5000u);  // many of them in cells that the surface cuts
  EXPECT_TRUE(twin == sorted.end());
}

TEST(Refinement, HoldsAFreeSurface) {
  const Scene<3> scene = test::sceneOf<3>(ball + "[relax]\n");
  EXPECT_LE(relaxedScatter(scene), mostScatter);
  for (const Vec<3>& x : scene.particles[field::position])
    EXPECT_LT(norm(x - Vec<3>{{1, 0, 0}}), 0.5);
}

TEST(Refinement, CrossesPeriodicFacesAndFluids) {
  // Refined are the seam of two fluids, and a disk around the corner in which the faces meet.
  const Scene<2> scene = test::sceneOf<2>(R"(
dimension = 2
spacing = 0.04
[domain]
lower = [0, 0]
upper = [1, 1]
periodic = ["x", "y"]
[geometry]
lower = { box = { lower = [0, 0], upper = [1, 0.5] } }
upper = { box = { lower = [0, 0.5], upper = [1, 1] } }
ground = { half_space = { point = [0, 0.5], normal = [0, 1] } }
corner = { disk = { center = [1, 1], radius = 0.1 } }
[[refine]]
near = "ground"
spacing = 0.5
distance = 0.04
[[refine]]
inside = "corner"
spacing = 0.4
[[fluid]]
region = "lower"
density = 10
mass = "exact"
[[fluid]]
region = "upper"
mass = "exact"
profile = { formula = "1 + x" }
particles = "equal_spacing"
[relax]
)");
  EXPECT_LE(relaxedScatter(scene), mostScatter);
  const auto& p = scene.particles;
  double lower = 0;
  std::array<int, 4> corners{};
  int nOutside = 0, nUneven = 0;
  for (std::size_t i = 0; i < p.nFluid(); ++i) {
    const Vec<2>& x = p[field::position][i];
    nOutside += p[field::material][i] != (x[1] < 0.5 ? 0 : 1);
    lower += x[1] < 0.5 ? p[field::mass][i] : 0;
    // The same volumes on both sides of the seam: a cell of the lattice, which is fitted to the box
    // and 2.8 % larger for that, to what exact masses make of it.
    const double s = p[field::smoothingLength][i] / 1.5;
    const double volume = p[field::mass][i] / p[field::density][i];
    nUneven += std::abs(volume / (std::sqrt(0.75) * s * s) / 1.028 - 1) > 0.01;
    const bool isRight = x[0] > 0.5, isUpper = x[1] > 0.5;
    const Vec<2> corner{{isRight ? 1.0 : 0.0, isUpper ? 1.0 : 0.0}};
    if (norm(x - corner) < 0.1) ++corners[static_cast<std::size_t>(isRight + 2 * isUpper)];
  }
  EXPECT_EQ(nOutside, 0);
  EXPECT_EQ(nUneven, 0);
  EXPECT_NEAR(lower, 5, 5e-12);
  // pi .01/4 over .866 .016^2 are 35 particles, about six of them in a row at the rim.
  for (const int n : corners) EXPECT_NEAR(n, 35, 6);
}

TEST(Refinement, ALine) {
  const Scene<1> scene = test::sceneOf<1>(R"(
dimension = 1
spacing = 0.01
[geometry]
line = { box = { lower = [0], upper = [1] } }
left = { box = { lower = [-1], upper = [0] } }
[[refine]]
near = "left"
spacing = 0.2
[[fluid]]
region = "line"
mass = "exact"
[[wall]]
region = "left"
[relax]
)");
  // s = .002 + .1 x up to x = .08: ln(5)/.1 particles, then .92/.01.
  EXPECT_NEAR(static_cast<double>(scene.particles.nFluid()), std::log(5) / 0.1 + 92, 1);
  EXPECT_LE(relaxedScatter(scene), mostScatter);
}

TEST(Refinement, DoesNotDependOnTheNumberOfThreads) {
  const auto scenes =
      test::forThreads([&] { return test::sceneOf<3>(ball + "[relax]\nmax_iterations = 5\n"); });
  for (const auto& scene : scenes)
    EXPECT_TRUE(std::ranges::equal(scene.particles[field::position],
                                   scenes.front().particles[field::position]));
}

// What is at fault.

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

TEST(Refinement, BadKeysAreErrorsWithARemedy) {
  const std::string sound = annulus(0.5);
  const auto expect = [&](const std::string& what, const std::string& with, const char* words) {
    const std::string message = test::messageOf<2>(replaced(sound, what, with));
    EXPECT_NE(message.find(words), std::string::npos) << with << "\n" << message;
    EXPECT_NE(message.find("test.toml:"), std::string::npos) << message;
  };
  const std::string spacing = "spacing = 0.5\n";
  expect(spacing, "spacing = 0\n", "refine");
  expect(spacing, "spacing = 0\n", "(0, 1]");
  expect(spacing, "spacing = 1.5\n", "(0, 1]");
  expect(spacing, "spacing = -1\n", "(0, 1]");
  expect(spacing, "spacing = nan\n", "finite");
  expect(spacing, "\n", "spacing");
  expect(spacing, spacing + "growth = 0\n", "(0, 0.3]");
  expect(spacing, spacing + "growth = -0.1\n", "(0, 0.3]");
  expect(spacing, spacing + "growth = 1e9\n", "(0, 0.3]");
  expect(spacing, spacing + "distance = -1\n", ">= 0");
  expect(spacing, spacing + "inside = \"gap\"\n", "needs either near");
  expect("near = \"shaft\"\n", "", "needs either near");
  expect("near = \"shaft\"\n", "inside = \"shaft\"\ndistance = 0.1\n", "goes with near only");
  expect("near = \"shaft\"", "near = \"shift\"", "shaft");
  expect("near", "nera", "near");
  expect("mass = ", "jitter = 0.1\nmass = ", "set lattice = \"random\"");
  expect("mass = \"exact\"", "profile = { formula = \"1\" }", "particles = \"equal_spacing\"");
}

std::vector<std::string> warningsOf(const std::string& text) {
  std::vector<std::string> warnings;
  test::sceneOf<2>(text, &warnings);
  return warnings;
}

TEST(Refinement, APlaceWithoutFluidIsAWarning) {
  EXPECT_TRUE(warningsOf(annulus(0.5)).empty());
  std::string far = annulus(0.5);
  far.insert(far.find("[[refine]]"), "far = { disk = { center = [9, 9], radius = 1 } }\n");
  const auto warnings = warningsOf(replaced(far, "near = \"shaft\"", "near = \"far\""));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("no fluid touches"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("refine"), std::string::npos) << warnings[0];
}

TEST(Refinement, ASetThatIsNotArrangedIsAWarning) {
  const auto warnings = warningsOf(replaced(annulus(0.5), "[relax]", ""));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("[relax]"), std::string::npos);
}

CheckReport checked(const std::string& text) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "case.toml") << text;
  return checkCase(folder.path() / "case.toml", {});
}

TEST(Refinement, CheckCountsIt) {
  const CheckReport report = checked(annulus(0.25));
  EXPECT_TRUE(report.findings.all().empty()) << describe(report);
  ASSERT_TRUE(report.estimate);
  const Scene<2> scene = test::sceneOf<2>(annulus(0.25));
  EXPECT_EQ(report.estimate->nFluid, static_cast<double>(scene.particles.nFluid()));
  EXPECT_EQ(report.estimate->nWalls, static_cast<double>(scene.particles.nWalls()));
}

TEST(Refinement, TooManyParticlesAreFoundBeforeTheyAreMade) {
  // 2.0e9 by the integral, of 640 bytes; 3e3 without the refinement.
  const std::string many = replaced(ball, "spacing = 0.5", "spacing = 0.0036");
  if (availableMemory().value_or(0) < 1.2e12) {
    const std::string message = test::messageOf<3>(many);
    EXPECT_NE(message.find("would hold 2.0"), std::string::npos) << message;
    EXPECT_NE(message.find("are available"), std::string::npos) << message;
    EXPECT_NE(message.find("or a larger one in [[refine]]"), std::string::npos) << message;
  }
  const std::string tooMany = replaced(ball, "spacing = 0.5", "spacing = 1e-5");
  const std::string message = test::messageOf<3>(tooMany);  // 2e13: (1e5)^3 in each of 93 cells
  EXPECT_NE(message.find("more than 2^31"), std::string::npos) << message;
  EXPECT_NE(message.find("[[refine]]"), std::string::npos) << message;
  const std::string surface = replaced(annulus(0.5), "spacing = 0.5", "spacing = 1e-9");
  EXPECT_NE(test::messageOf<2>(surface).find("more than 2^31"), std::string::npos);
}

TEST(Refinement, WallsThatAreTooFineToTraceAreRefused) {
  // Nodes 1e-6 m apart in .05 m^2 take 4e11 bytes; of fluid there are 2e5 particles.
  if (availableMemory().value_or(4e11) >= 4e11) GTEST_SKIP() << "this machine has the memory";
  const std::string text =
      replaced(annulus(0.001), "spacing = 0.001", "spacing = 0.001\ngrowth = 0.3");
  const std::string message = test::messageOf<2>(text);
  EXPECT_NE(message.find("method = \"lattice\""), std::string::npos) << message;
}

TEST(Refinement, EstimatesToAPercent) {
  // A spacing at which fluid and walls are too many to be counted.
  const std::string text = replaced(annulus(0.5), "spacing = 0.005", "spacing = 0.00005");
  const CheckReport report = checked(text);
  ASSERT_TRUE(report.estimate);
  EXPECT_FALSE(report.estimate->isCounted);
  // s = .000025 + .1 x up to x = .00025, then .00005.
  double wanted = pi * (0.01 - 0.04025 * 0.04025) / (std::sqrt(0.75) * 2.5e-9);
  constexpr int n = 1000;
  for (int k = 0; k < n; ++k) {
    const double x = (k + 0.5) / n * 0.00025, s = 0.000025 + 0.1 * x;
    wanted += 2 * pi * (0.04 + x) / (std::sqrt(0.75) * s * s) * 0.00025 / n;
  }
  EXPECT_NEAR(report.estimate->nFluid / wanted, 1, 0.01);  // 1e5 samples of a narrow band
  // Three layers on each side: of the shaft half as thick, and twice as many in each.
  const double shaft = 2 * pi * 0.04 * 3 / 0.000025, housing = 2 * pi * 0.1 * 3 / 0.00005;
  EXPECT_NEAR(report.estimate->nWalls * std::sqrt(0.75) / (shaft + housing), 1, 0.05);
}

}  // namespace
}  // namespace plenum
