// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/ictools/scenes.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

/// A blob in a wind that is the rest of the domain: the wind's volume is known by its lattice only.
const std::string blobInWind = R"(
dimension = 2
spacing = 0.04
[domain]
lower = [0, 0]
upper = [1, 1]
periodic = ["x", "y"]
[geometry]
blob = { disk = { center = [0.5, 0.5], radius = 0.25 } }
[[fluid]]
name = "blob"
region = "blob"
density = 3
jitter = 0.2
[[fluid]]
name = "wind"
)";

Generated<2> generated(const std::string& text, const Scene<2>* placesOf = nullptr) {
  const CaseNode root = CaseNode::parse(text, "test.toml");
  return generate<2>(root, readCase(root), "test.toml", [](const auto&) {}, {{}, placesOf});
}

template <Rank R>
auto values(const Scene<2>& scene, Field<R> field) {
  const auto span = scene.particles[field];
  return std::vector(span.begin(), span.end());
}

TEST(PlacesOfSet, AreTakenAsTheyAreWithMasses) {
  const Scene<2> first = generated(blobInWind).scene;
  Scene<2> sorted = first;  // a run leaves its particles in another order
  std::vector<std::uint32_t> order(first.particles.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    order[k] = static_cast<std::uint32_t>(order.size() - 1 - k);
  std::vector<std::byte> scratch(order.size() * ParticleSet<2>::permuteBytes);
  sorted.particles.permute(order, scratch);
  const Scene<2> second = generated(blobInWind, &sorted).scene;
  EXPECT_EQ(values(first, field::position), values(second, field::position));
  EXPECT_EQ(values(first, field::mass), values(second, field::mass));
  EXPECT_EQ(values(first, field::material), values(second, field::material));
}

TEST(PlacesOfSet, AreWhereARelaxationGoesOn) {
  const Generated<2> whole = generated(blobInWind + "[relax]\n");
  const Scene<2> first = generated(blobInWind).scene;
  const Generated<2> later = generated(blobInWind + "[relax]\n", &first);
  ASSERT_EQ(whole.relaxation->history.size(), later.relaxation->history.size());
  EXPECT_EQ(values(whole.scene, field::position), values(later.scene, field::position));
}

/// A disk whose particles have different volumes; `more` says how.
std::string unevenDisk(const std::string& fluid, const std::string& more = "") {
  return R"(
dimension = 2
spacing = 0.05
[geometry]
disk = { disk = { center = [0, 0], radius = 0.5 } }
core = { disk = { center = [0, 0], radius = 0.1 } }
[[fluid]]
region = "disk"
)" + fluid +
         more;
}

TEST(PlacesOfSet, AreWhereUnevenSetsGoOnToo) {
  const std::string refined =
      unevenDisk("mass = \"exact\"\n", "[[refine]]\ninside = \"core\"\nspacing = 0.5\n");
  const std::string dense = unevenDisk("profile = { power_law = { core_radius = 0.2 } }\n");
  for (const std::string& text : {refined, dense}) {
    const Generated<2> whole = generated(text + "[relax]\nmax_iterations = 20\n");
    const Scene<2> first = generated(text).scene;
    const Generated<2> later = generated(text + "[relax]\nmax_iterations = 20\n", &first);
    EXPECT_EQ(values(whole.scene, field::position), values(later.scene, field::position)) << text;
    EXPECT_EQ(values(whole.scene, field::mass), values(later.scene, field::mass)) << text;
  }
}

std::string messageOf(const std::string& text, const Scene<2>& places) {
  try {
    generated(text, &places);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PlacesOfSet, OfAnotherCaseAreRefused) {
  const Scene<2> scene = generated(blobInWind).scene;
  std::string other = blobInWind;
  other.replace(other.find("name = \"wind\""), 13, "name = \"gas\"");
  EXPECT_NE(messageOf(other, scene).find("fluids"), std::string::npos);
  std::string smaller = blobInWind;
  smaller.replace(smaller.find("0.25"), 4, "0.15");
  EXPECT_NE(messageOf(smaller, scene).find("lie outside of the region of fluid \"blob\""),
            std::string::npos);
}

}  // namespace
}  // namespace plenum
