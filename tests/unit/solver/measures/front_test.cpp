// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/front.hpp"

#include "tests/unit/solver/measures/water.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

constexpr double d = 0.05;

template <int Dim>
double frontOf(const Scene<Dim>& scene, const FrontSettings& settings = {}) {
  const auto state = test::observed(scene);
  std::vector<Figure> row;
  Front<Dim>(settings, state, "measures.front").addTo(row, state);
  return row.at(0).value;
}

TEST(Front, IsTheOutermostParticleOfABox) {
  const Scene<2> scene = test::stillWater<2>({{1, 0.6}}, d);
  // Coordinates of particles: no arithmetic but that of the lattice.
  EXPECT_DOUBLE_EQ(frontOf(scene), 1 - d / 2);
  EXPECT_DOUBLE_EQ(frontOf(scene, {"x", "-", ""}), d / 2);
  EXPECT_DOUBLE_EQ(frontOf(scene, {"y", "+", ""}), 0.6 - d / 2);
  EXPECT_DOUBLE_EQ(frontOf(test::stillWater<1>({{1}}, d)), 1 - d / 2);
  EXPECT_DOUBLE_EQ(frontOf(test::stillWater<3>({{0.3, 0.3, 0.3}}, d), {"z", "+", ""}), 0.3 - d / 2);
}

TEST(Front, LostDropletsDoNotCountAndTonguesDo) {
  Scene<2> scene = test::stillWater<2>({{1, 0.6}}, d);
  const auto x = scene.particles[field::position];
  // A droplet of three: two neighbours each.
  x[0] = {{2, 0.3}};
  x[1] = {{2 + d, 0.3}};
  x[2] = {{2, 0.3 + d}};
  EXPECT_DOUBLE_EQ(frontOf(scene), 1 - d / 2);
  // A tongue two rows thick: its tip has the one beside it, and two or more behind.
  for (std::size_t k = 0; k < 10; ++k)
    x[3 + k] = {{1 + (static_cast<double>(k / 2) + 0.5) * d, (k % 2 == 0 ? 0.5 : 1.5) * d}};
  EXPECT_DOUBLE_EQ(frontOf(scene), 1 + 4.5 * d);
}

TEST(Front, OfOneMaterial) {
  Scene<2> scene = test::stillWater<2>({{1, 0.6}}, d);
  scene.info.materials.push_back({"air", 1});
  scene.particles.add({field::material});
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    scene.particles[field::material][i] = scene.particles[field::position][i][0] > 0.5;
  EXPECT_DOUBLE_EQ(frontOf(scene, {"x", "+", "water"}), 0.5 - d / 2);
  EXPECT_DOUBLE_EQ(frontOf(scene, {"x", "-", "air"}), 0.5 + d / 2);
  // A droplet of water in air has neighbours, but none of water.
  scene.particles[field::position][0] = {{0.8, 0.3}};
  EXPECT_DOUBLE_EQ(frontOf(scene, {"x", "+", "water"}), 0.5 - d / 2);
  EXPECT_EQ(
      test::refusalOf([&] {
        frontOf(scene, {"x", "+", "wator"});
      }),
      "measures.front.material = \"wator\": no such fluid; this scene has water, air; did you "
      "mean \"water\"?");
}

TEST(Front, NothingIsOutermostOnAPeriodicAxis) {
  Scene<2> scene = test::stillWater<2>({{1, 0.6}}, d);
  scene.info.domain.periodic = {true, false};
  const std::string message = test::refusalOf([&] { frontOf(scene); });
  EXPECT_NE(message.find("measures.front.axis = \"x\": the domain is periodic"), std::string::npos)
      << message;
}

}  // namespace
}  // namespace plenum
