// SPDX-License-Identifier: GPL-3.0-or-later
//
// What gases start with: densities are given, pressures and energies fit them.
#include "ictools/check.hpp"
#include "particles/ideal_gas.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <numbers>

namespace plenum {
namespace {

/// Of a few roundings of numbers of order one.
constexpr double roundOff = 1e-14;

/// A tube of 24 m in 1-D, dense gas in the middle; `keys` go to both fluids and `solver` to its
/// table.
std::string tube(const std::string& solver, const std::string& keys) {
  return R"(
dimension = 1
spacing = 0.125
[domain]
lower = [-12]
upper = [12]
periodic = ["x"]
[geometry]
all = { box = { lower = [-12], upper = [12] } }
middle = { box = { lower = [-6], upper = [6] } }
rest = { difference = ["all", "middle"] }
[solver]
)" + solver +
         R"(
[[fluid]]
region = "middle"
density = 4.0
)" + keys +
         R"(
[[fluid]]
region = "rest"
density = 1.0
equal_mass_with = "middle"
)" + keys;
}

std::string idealGas(const std::string& keys) {
  return tube("equation_of_state = \"ideal_gas\"\nadiabatic_index = 1.4", keys);
}

void expectMessage(const std::string& text, const std::vector<std::string>& parts) {
  const std::string message = test::messageOf<1>(text);
  EXPECT_TRUE(message.starts_with("test.toml:")) << message;
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << "\n is not in: " << message;
}

TEST(GasStates, OneDimensionalTubeFillsItsPeriodicDomain) {
  const auto scene = test::sceneOf<1>(tube("equation_of_state = \"isothermal\"", ""));
  const ParticleSet<1>& particles = scene.particles;
  ASSERT_EQ(particles.size(), 96u + 24u);  // 12 m at .125 m, and 12 m at .5 m
  EXPECT_FALSE(particles.has(field::internalEnergy));
  std::vector<double> x;
  for (const Vec<1>& place : particles[field::position]) x.push_back(place[0]);
  std::ranges::sort(x);
  double volume = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    EXPECT_NEAR(particles[field::mass][i], 0.5, roundOff);
    volume += particles[field::mass][i] / particles[field::density][i];
  }
  EXPECT_NEAR(volume, 24, 24 * roundOff * 10);  // a sum of 120 terms
  // Half a spacing on both sides of the seams and of the periodic face.
  const auto seam = static_cast<std::size_t>(std::ranges::lower_bound(x, 6.0) - x.begin());
  EXPECT_NEAR(x[seam - 1], 6 - 0.0625, 1e-9);  // lattice points are k d, d to 1e-16
  EXPECT_NEAR(x[seam], 6 + 0.25, 1e-9);
  EXPECT_NEAR(x.front(), -12 + 0.25, 1e-9);
  EXPECT_NEAR(x.back(), 12 - 0.25, 1e-9);
}

TEST(GasStates, IsothermalPressuresFollowDensities) {
  const auto scene =
      test::sceneOf<1>(tube("equation_of_state = \"isothermal\"\nsound_speed = 3", ""));
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    EXPECT_DOUBLE_EQ(scene.particles[field::pressure][i], 9 * scene.particles[field::density][i]);
}

TEST(GasStates, AdaptiveLengthsFollowVolumes) {
  const auto scene = test::sceneOf<1>(
      tube("equation_of_state = \"isothermal\"\nsmoothing_length = 2\nadaptive = {}", ""));
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    EXPECT_DOUBLE_EQ(scene.particles[field::smoothingLength][i],
                     2 * scene.particles[field::mass][i] / scene.particles[field::density][i]);
}

TEST(GasStates, AdaptiveLengthsOfAHexagonalLattice) {
  const std::string text = test::periodicBox("0.05", "lattice = \"hexagonal\"\ndensity = 1\n");
  const auto own = test::sceneOf<2>(text + "[solver]\nsmoothing_length = 2\nadaptive = {}\n");
  const double mass = own.particles[field::mass][0], h = own.particles[field::smoothingLength][0];
  EXPECT_DOUBLE_EQ(h, 2 * std::sqrt(mass));  // density 1
  // That of the scene is that of the lattice before it is stretched to the domain, by half of
  // what 24 rows of .0433 m in 1 m leave, 3.9 %.
  EXPECT_NEAR(own.info.smoothingLength, h, 0.02 * h);
  const auto one = test::sceneOf<2>(text + "[solver]\nsmoothing_length = 2\n");
  EXPECT_DOUBLE_EQ(one.particles[field::smoothingLength][0], 0.1);
}

/// A disk of dense gas in a periodic box of 1 m.
std::string cloud(const std::string& radius, const std::string& density) {
  return R"(
dimension = 2
spacing = 0.05
[domain]
lower = [0, 0]
upper = [1, 1]
periodic = ["x", "y"]
[geometry]
disk = { disk = { center = [0.5, 0.5], radius = )" +
         radius + R"( } }
[solver]
equation_of_state = "isothermal"
smoothing_length = 2
adaptive = {}
[[fluid]]
name = "cloud"
region = "disk"
density = 10
[[fluid]]
name = "wind"
equal_mass_with = "cloud"
density = )" +
         density + "\n";
}

TEST(GasStates, NeighboursThatCheckPrints) {
  const auto neighbours = [](const std::string& text) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "case.toml") << text;
    return checkCase(folder.path() / "case.toml", {}).estimate.value().neighbours;
  };
  // The finer fluid stands first; 4h = 4 spacings of .125 m or of the lattice's own.
  const std::string isothermal = "equation_of_state = \"isothermal\"\nsmoothing_length = 2\n";
  EXPECT_NEAR(neighbours(tube(isothermal, "")), 7, 1e-9);  // 8 volumes, less the particle itself
  EXPECT_NEAR(neighbours(tube(isothermal + "adaptive = {}", "")), 7, 1e-9);
  // A disk of radius 2 * 2 (V)^(1/2) holds 16 pi volumes.
  EXPECT_NEAR(neighbours(cloud("0.3", "8")), 16 * std::numbers::pi - 1, 1e-9);
}

TEST(GasStates, EveryKeySaysTheEnergy) {
  const double gamma = 1.4;
  const auto check = [&](const std::string& key, auto expected) {
    const auto scene = test::sceneOf<1>(idealGas(key));
    const ParticleSet<1>& p = scene.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double e = p[field::internalEnergy][i], rho = p[field::density][i];
      const double wanted = expected(p[field::position][i][0], rho);
      ASSERT_NEAR(e, wanted, 4 * roundOff * wanted) << key;
      ASSERT_NEAR(p[field::pressure][i], (gamma - 1) * rho * e, 4 * roundOff * rho * e) << key;
    }
  };
  check("pressure = 2", [&](double, double rho) { return 2 / (0.4 * rho); });
  check("pressure_formula = \"2 + x/12\"",
        [&](double x, double rho) { return (2 + x / 12) / (0.4 * rho); });
  check("internal_energy = 3", [](double, double) { return 3.0; });
  check("internal_energy_formula = \"3 + x/12\"", [](double x, double) { return 3 + x / 12; });
  // A diatomic gas: e = 5/2 k_B T/(nu m_H), with nu = 1 and T = 300 K 6.187e6 J/kg.
  check("temperature = 300",
        [](double, double) { return 2.5 * boltzmannConstant * 300 / hydrogenMass; });
  EXPECT_NEAR(energyOfTemperature(300, 1, 1.4), 6.187e6, 1e3);  // four digits
}

TEST(GasStates, EnergyIsSaidOnceAndPositive) {
  expectMessage(idealGas(""), {"fluid[0]", "says nothing of its energy", "internal_energy"});
  expectMessage(idealGas("pressure = 1\ntemperature = 1"), {"temperature", "excludes pressure"});
  expectMessage(idealGas("pressure = 0"), {"pressure = 0", "must be > 0"});
  expectMessage(idealGas("internal_energy = -1"), {"internal_energy = -1", "> 0"});
  expectMessage(idealGas("pressure_formula = \"x\""),
                {"pressure_formula", "gives -", "at (-", "> 0 everywhere"});
}

TEST(GasStates, KeysOfAnotherEquationOfState) {
  const std::string isothermal = "equation_of_state = \"isothermal\"";
  expectMessage(tube(isothermal, "pressure = 1"), {"pressure = 1", "p = c^2 rho"});
  expectMessage(tube(isothermal, "temperature = 1"), {"temperature = 1", "ideal_gas"});
  expectMessage(tube(isothermal, "hydrostatic = { surface = 1 }"), {"hydrostatic", "profile"});
  expectMessage(tube(isothermal, "tait_exponent = 7"), {"tait_exponent", "of a liquid"});
  expectMessage(tube("", "internal_energy = 1"), {"internal_energy = 1", "\"tait\"", "ideal_gas"});
  expectMessage(tube("", "energy_deposit = { point = [0], energy = 1, radius = 1 }"),
                {"energy_deposit", "\"tait\""});
  expectMessage(idealGas("pressure = 1\nsound_speed = 3"), {"sound_speed", "follows"});
}

/// A deposit near a corner of a periodic box.
std::string blastCase(const std::string& radius) {
  return test::periodicBox("0.05",
                           "lattice = \"square\"\ninternal_energy = 1e-5\n"
                           "energy_deposit = { point = [0.01, 0.99], energy = 2.5, "
                           "radius = " +
                               radius + " }\n") +
         "[solver]\nequation_of_state = \"ideal_gas\"\n";
}

TEST(GasStates, DepositIsExactAcrossPeriodicFaces) {
  const auto scene = test::sceneOf<2>(blastCase("0.2"));
  const ParticleSet<2>& p = scene.particles;
  double sum = 0;
  bool isInEachCorner[2][2] = {};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double e = p[field::internalEnergy][i] - 1e-5;
    sum += p[field::mass][i] * e;
    const Vec<2> x = p[field::position][i];
    if (e > 0) isInEachCorner[x[0] > 0.5][x[1] > 0.5] = true;
    EXPECT_NEAR(p[field::pressure][i], 2.0 / 3 * p[field::internalEnergy][i],
                1e-14 * (1 + p[field::internalEnergy][i]));
  }
  EXPECT_NEAR(sum, 2.5, 2.5 * 1e-13);  // a sum of 400 terms, from each of which 1e-5 was taken
  for (const auto& row : isInEachCorner)
    for (const bool isIn : row) EXPECT_TRUE(isIn);
}

TEST(GasStates, DepositThatReachesNobody) {
  const std::string message = test::messageOf<2>(blastCase("0.001"));
  EXPECT_NE(message.find("radius"), std::string::npos) << message;
  // The nearest particle stands at (.025, .975), .0212 m from the point.
  EXPECT_NE(message.find("0.0212132 m away"), std::string::npos) << message;
}

TEST(GasStates, PeriodicDomainsThatAreTooNarrow) {
  EXPECT_EQ(test::messageOf<2>(cloud("0.3", "8")), "");
  const std::string large = test::messageOf<2>(cloud("0.6", "8"));
  for (const char* part : {"fluid \"cloud\"", "1.2 m long along x", "0.1 m beyond", "of 1 m"})
    EXPECT_NE(large.find(part), std::string::npos) << part << "\n is not in: " << large;
  const std::string thin = test::messageOf<2>(cloud("0.3", "1"));
  // 20 columns and 24 rows in 1 m, so 2h = 4 (10/480)^(1/2) m.
  for (const char* part :
       {"periodic axis x is 1 m", "fluid \"wind\"", "0.57735 m", "at least 1.1547 m"})
    EXPECT_NE(thin.find(part), std::string::npos) << part << "\n is not in: " << thin;
}

std::string gasBesideWall(const std::string& wall) {
  return R"(
dimension = 1
spacing = 0.1
[geometry]
room = { box = { lower = [0], upper = [2] } }
[solver]
equation_of_state = "ideal_gas"
adiabatic_index = 1.4
wall_pressure = "initial"
[[fluid]]
region = "room"
density = 2
pressure = 3
[[wall]]
outside = "room"
)" + wall;
}

TEST(GasStates, WallsAreAsTheFluidOrAsTheySay) {
  const auto energyOfWalls = [](const std::string& keys) {
    const auto scene = test::sceneOf<1>(gasBesideWall(keys));
    EXPECT_GT(scene.particles.nWalls(), 0u);
    const std::size_t last = scene.particles.size() - 1;
    const double e = scene.particles[field::internalEnergy][last];
    EXPECT_NEAR(scene.particles[field::pressure][last],
                0.4 * scene.particles[field::density][last] * e, 4 * roundOff * e);
    return e;
  };
  EXPECT_NEAR(energyOfWalls(""), 3 / (0.4 * 2), 4 * roundOff);
  EXPECT_NEAR(energyOfWalls("density = 4"), 3 / (0.4 * 4), 4 * roundOff);
  EXPECT_NEAR(energyOfWalls("pressure = 1"), 1 / (0.4 * 2), 4 * roundOff);
  EXPECT_NEAR(energyOfWalls("internal_energy = 7"), 7, 4 * roundOff);
  expectMessage(gasBesideWall("pressure = 1\ninternal_energy = 7"),
                {"internal_energy", "excludes pressure"});
  expectMessage(gasBesideWall("pressure = -1"), {"pressure = -1", "must be > 0"});
}

}  // namespace
}  // namespace plenum
