// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shipped cases give the same particles from formulas and from the CAD files beside them, and
// fluid and walls meet as they should.
#include "geometry/text_reader.hpp"
#include "tests/support/named_region.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace plenum {
namespace {

using Changes = std::vector<std::pair<std::string, std::string>>;

const std::filesystem::path folder = PLENUM_CASES;
const std::string built = PLENUM_CAD_FILES;

/// A case of cases/, before [relax], with some of its values changed as --set does.
CaseNode caseOf(const std::string& name, const Changes& changes) {
  const std::string text = readWholeFile(folder / name);
  CaseNode root = CaseNode::parse(text.substr(0, text.find("[relax]")), (folder / name).string());
  for (const auto& [key, value] : changes) root.set(key, value);
  return root;
}

template <int Dim>
Scene<Dim> sceneOf(const CaseNode& root) {
  return generate<Dim>(root, readCase(root), root.fileName(), [](const std::string&) {}).scene;
}

template <int Dim>
GeometryPtr<Dim> regionOf(const CaseNode& root, const std::string& name) {
  const std::filesystem::path caseFolder = std::filesystem::path(root.fileName()).parent_path();
  return test::regionNamed(GeometrySet<Dim>::read(*root.find("geometry"), caseFolder), name);
}

/// Positions of fluid or walls, sorted by their coordinates, rounded to `grain` [m] if that is
/// given.
template <int Dim>
std::vector<Vec<Dim>> sorted(const Scene<Dim>& scene, bool fluid, double grain = 0) {
  const auto all = scene.particles[field::position];
  const auto n = static_cast<std::ptrdiff_t>(scene.particles.nFluid());
  std::vector<Vec<Dim>> points(fluid ? all.begin() : all.begin() + n,
                               fluid ? all.begin() + n : all.end());
  const auto key = [&](Vec<Dim> x) {
    if (grain > 0)
      for (int a = 0; a < Dim; ++a) x[a] = std::round(x[a] / grain);
    return x.components;
  };
  std::ranges::sort(points, {}, key);
  return points;
}

/// As many particles, in the same places: flat faces from CAD are off by no more than the digits of
/// the file (1e-10 m with millimetres to 15 digits), which move where lattices start.
template <int Dim>
void expectSameParticles(const Scene<Dim>& scene, const Scene<Dim>& exact, double spacing) {
  for (const bool fluid : {true, false}) {
    const auto a = sorted(scene, fluid, 1e-4 * spacing);
    const auto b = sorted(exact, fluid, 1e-4 * spacing);
    ASSERT_EQ(a.size(), b.size()) << (fluid ? "fluid" : "walls");
    for (std::size_t k = 0; k < a.size(); ++k) ASSERT_LT(norm(a[k] - b[k]), 1e-9);
  }
}

/// The fluid stands half a spacing off the walls: no pair is nearer than a spacing, nobody is
/// beyond the room.
template <int Dim>
void expectSoundAtWalls(const Scene<Dim>& scene, const Geometry<Dim>& room, double spacing) {
  const auto x = scene.particles[field::position];
  const std::size_t nFluid = scene.particles.nFluid();
  for (std::size_t i = 0; i < nFluid; ++i)
    ASSERT_LT(room.signedDistance(x[i]), -0.5 * spacing * (1 - 1e-6));
  for (std::size_t w = nFluid; w < x.size(); ++w) {
    ASSERT_GT(room.signedDistance(x[w]), 0.5 * spacing * (1 - 1e-6));
    for (std::size_t i = 0; i < nFluid; ++i)
      ASSERT_GT(normSquared(x[w] - x[i]), spacing * spacing * (1 - 1e-6));
  }
}

TEST(ShippedCases, Dam) {
  const std::string name = "initial_conditions/dam.toml";
  const CaseNode root = caseOf(name, {});
  const Scene<2> exact = sceneOf<2>(root);
  EXPECT_EQ(exact.particles.nFluid(), 50u * 20);
  EXPECT_EQ(exact.particles.nWalls(), 106u * 56 - 100 * 50 - 4);  // three layers, corners round
  expectSoundAtWalls<2>(exact, *regionOf<2>(root, "room"), 0.01);
  const auto with = [&](const std::string& water, const std::string& room) {
    return caseOf(name, {{"geometry.water", "{file=\"" + water + "\"}"},
                         {"geometry.room", "{file=\"" + room + "\"}"}});
  };
  for (const CaseNode& other : {with("../cad/dam_water.step", "../cad/dam_room.step"),
                                with("../cad/dam_water.geo", "../cad/dam_room.geo"),
                                with(built + "/dam_water.wkt", built + "/dam_room.wkt")})
    expectSameParticles<2>(sceneOf<2>(other), exact, 0.01);
}

TEST(ShippedCases, Tank) {
  const std::string name = "initial_conditions/tank.toml";
  const Changes coarse = {{"spacing", "0.02"},
                          {"solver.smoothing_length", "0.9"}};  // walls of two layers are enough
  const CaseNode root = caseOf(name, coarse);
  const Scene<3> exact = sceneOf<3>(root);
  EXPECT_EQ(exact.particles.nFluid(), 20u * 10 * 8);
  EXPECT_EQ(exact.particles.nWalls(), 24u * 14 * 12 - 20 * 10 * 10);
  expectSoundAtWalls<3>(
      exact, *regionOf<3>(caseOf(name, {{"geometry.room.box.upper", "[0.4, 0.2, 0.3]"}}), "room"),
      0.02);
  const auto with = [&](const std::string& water, const std::string& walls) {
    Changes changes = coarse;
    if (!water.empty()) changes.emplace_back("geometry.water", "{file=\"" + water + "\"}");
    changes.emplace_back("geometry.walls", "{file=" + walls + "}");
    return caseOf(name, changes);
  };
  for (const CaseNode& other : {with("../cad/tank_water.step", "\"../cad/tank_walls.step\""),
                                with(built + "/tank_water.stl", "\"" + built + "/tank_walls.stl\""),
                                with("", "\"../cad/tank_surface.stl\", thickness=0.04")}) {
    expectSameParticles<3>(sceneOf<3>(other), exact, 0.02);
    // 0.48 x 0.28 x 0.24 m without the room: the digits of the file once more.
    EXPECT_NEAR(regionOf<3>(other, "walls")->volume().value, 0.48 * 0.28 * 0.24 - 0.4 * 0.2 * 0.2,
                1e-9);
  }
}

TEST(ShippedCases, Blob) {
  const std::string name = "initial_conditions/blob.toml";
  const Changes origin = {{"fluid[0].lattice_origin", "[0.51, 0.52, 0.53]"}};
  const CaseNode root = caseOf(name, origin);
  const Scene<3> exact = sceneOf<3>(root);
  const auto ball = regionOf<3>(root, "blob");
  const double tolerance = 1e-3;
  for (const std::string& file : {std::string("../cad/blob.step"), built + "/blob.stl"}) {
    Changes changes = origin;
    changes.emplace_back("geometry.blob", "{file=\"" + file +
                                              "\", tolerance=1e-3, scale=2.5, "
                                              "translate=[0.5, 0.5, 0.5]}");
    const Scene<3> scene = sceneOf<3>(caseOf(name, changes));
    // The lattices are the same: what one set has and the other has not lies at the surface.
    const auto a = sorted(scene, true), b = sorted(exact, true);
    const auto coordinates = [](const Vec<3>& x) { return x.components; };
    std::vector<Vec<3>> different;
    std::ranges::set_symmetric_difference(a, b, std::back_inserter(different), {}, coordinates,
                                          coordinates);
    for (const Vec<3>& x : different)
      EXPECT_LE(std::abs(ball->signedDistance(x)), tolerance + 1e-12);
    // So many points of the finer lattice, and fewer of the other, lie so near to the surface.
    const double strip = 2 * tolerance * 4 * 3.1416 * 0.25 * 0.25;
    EXPECT_LE(static_cast<double>(different.size()), 2 * strip * 4 * std::sqrt(2.) / 1.25e-4);
  }
}

/// Of a wedge under a leaning wall, a half cylinder and a box, without the baffle [m^3].
constexpr double waterOfVessel() {
  constexpr double pi = 3.14159265358979, reach = 0.06712797, depth = 0.1;
  constexpr double behindWall = 0.2 * (0.5 * reach * 0.08 + reach * 0.02);
  constexpr double baffle = 0.025 * 0.14 * 0.05;
  return depth * (0.3 * 0.2 + pi * 0.1 * 0.1 / 2) - behindWall - baffle;
}

TEST(ShippedCases, Vessel) {
  const std::string name = "cad_vessel.toml";
  const Changes coarse = {{"spacing", "0.0125"}};
  const CaseNode root = caseOf(name, coarse);
  const Scene<3> fromStep = sceneOf<3>(root);
  const auto vessel = regionOf<3>(root, "vessel");
  constexpr double tolerance = 5e-4;  // of the triangles in vessel.stl [m]
  Changes changes = coarse;
  changes.emplace_back("geometry.vessel", "{file=\"cad/vessel.stl\"}");
  const CaseNode other = caseOf(name, changes);
  const Scene<3> fromStl = sceneOf<3>(other);
  // Chords of the half cylinder cut off two thirds of their largest distance from it.
  const double cutOff = 2. / 3 * tolerance * 3.1416 * 0.1 * 0.1;
  for (const CaseNode& each : {root, other})
    EXPECT_NEAR(regionOf<3>(each, "water")->volume().value, waterOfVessel(), cutOff);
  // The lattices are the same: what one set has and the other has not lies at the surface.
  const auto a = sorted(fromStep, true, 1e-6), b = sorted(fromStl, true, 1e-6);
  const auto rounded = [](Vec<3> x) {
    for (int k = 0; k < 3; ++k) x[k] = std::round(x[k] / 1e-6);
    return x.components;
  };
  std::vector<Vec<3>> different;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(different), {}, rounded, rounded);
  for (const Vec<3>& x : different) EXPECT_LE(std::abs(vessel->signedDistance(x)), tolerance);
  // As many as there are in a layer of the tolerance along the half cylinder, and twice that.
  EXPECT_LE(static_cast<double>(different.size()),
            3 * tolerance * 3.1416 * 0.1 * 0.1 / std::pow(0.0125, 3));
}

}  // namespace
}  // namespace plenum
