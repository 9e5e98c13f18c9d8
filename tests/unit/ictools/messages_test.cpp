// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bad input: every message names file, line, key and remedy.
#include "tests/unit/ictools/scenes.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

/// The shaft with one line replaced.
std::string shaftWith(const std::string& line, const std::string& replacement) {
  std::string text = test::shaftCase();
  const std::size_t at = text.find(line + "\n");
  EXPECT_NE(at, std::string::npos) << line;
  return text.replace(at, line.size(), replacement);
}

void expectMessage(const std::string& text, const std::vector<std::string>& parts) {
  const std::string message = test::messageOf<2>(text);
  EXPECT_TRUE(message.starts_with("test.toml:")) << message;
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << "\n is not in: " << message;
}

TEST(Messages, UnknownKeysAndNames) {
  expectMessage(shaftWith("lattice = \"hexagonal\"", "latice = \"hexagonal\""),
                {":12:", "latice", "did you mean 'lattice'"});
  expectMessage(shaftWith("lattice = \"hexagonal\"", "lattice = \"hexagon\""),
                {":12:", "fluid[0].lattice", "did you mean \"hexagonal\""});
  expectMessage(shaftWith("region = \"gap\"", "region = \"gab\""), {":11:", "region", "gap"});
  expectMessage(shaftWith("outside = \"housing\"", "outside = \"house\""), {"outside", "housing"});
  expectMessage(shaftWith("layers = 4", "lattice_of = \"water\""),
                {"wall[1].lattice_of", "known: gap"});
  expectMessage("spacing = 0.1\ncontainer = \"tank\"\n[[fluid]]\nregion = \"tank\"\n",
                {":4:", "no [geometry]"});
}

TEST(Messages, ValuesOutOfRange) {
  expectMessage(shaftWith("layers = 4", "layers = 0"), {"wall[1].layers = 0", "in [1, 1000]"});
  expectMessage(shaftWith("lattice_origin = [0, 0]", "density = -1"), {"density = -1", "> 0"});
  expectMessage(shaftWith("lattice_origin = [0, 0]", "lattice_origin = [0, 0, 0]"),
                {"3 components", "2 dimensions"});
  expectMessage(shaftWith("lattice = \"hexagonal\"", "lattice = \"fcc\""),
                {"lattice = \"fcc\"", "2 dimensions", "hexagonal, square or random"});
  expectMessage(shaftWith("lattice = \"hexagonal\"", "lattice = \"random\""),
                {"lattice_origin", "leave it out"});
  expectMessage(shaftWith("rotation = { rpm = 1000 }", "rotation = { rpm = 1000, omega = 1 }"),
                {"rotation", "either rpm", "omega"});
  expectMessage(shaftWith("rotation = { rpm = 1000 }", "outside = \"housing\""),
                {"wall[0]", "region", "outside"});
  expectMessage(shaftWith("layers = 4", "pressure = 1\nhydrostatic = { surface = 1 }"),
                {"pressure", "excludes hydrostatic"});
  expectMessage(shaftWith("lattice_origin = [0, 0]", "hydrostatic = { surface = 1 }"),
                {"hydrostatic", "solver.gravity"});
  expectMessage(shaftWith("layers = 8", "name = \"housing\"") + "name = \"housing\"\n",
                {"name = \"housing\"", "another wall"});
}

TEST(Messages, GeometryThatDoesNotFitTheSpacing) {
  expectMessage(shaftWith("spacing = 0.005", "spacing = 0.5"),
                {"region = \"gap\"", "no particle", "0.2 m", "smaller spacing"});
  expectMessage(shaftWith("spacing = 0.005", "spacing = 1e-7"),
                {"region = \"gap\"", "more than 2^31", "spacing of at least"});
  // A slit of 2 mm beside a chamber: no row of particles stands in it.
  expectMessage(R"(
dimension = 2
spacing = 0.01
[geometry]
chamber = { box = { lower = [0, 0], upper = [0.2, 0.2] } }
slit = { box = { lower = [0.19, 0.0995], upper = [0.4, 0.1015] } }
part = { union = ["chamber", "slit"] }
[[fluid]]
region = "part"
lattice = "square"
)",
                {"region = \"part\"", "thick", "less than the spacing of 0.01", "spacing of 0.00"});
  expectMessage(
      "spacing = 0.1\n[geometry]\nall = { half_space = { point = [0, 0], normal = [0, 1] "
      "} }\n[[fluid]]\nregion = \"all\"\n",
      {":5:", "infinite along x", "intersect it with a box"});
}

TEST(Messages, SharpCornersAreNotThinParts) {
  std::vector<std::string> warnings;
  test::sceneOf<2>(R"(
dimension = 2
spacing = 0.01
[geometry]
corner = { box = { lower = [0, 0], upper = [0.2, 0.2] } }
hole = { disk = { center = [0.2, 0.2], radius = 0.15 } }
part = { difference = ["corner", "hole"] }
[[fluid]]
region = "part"
)",
                   &warnings);
  EXPECT_TRUE(warnings.empty()) << warnings.front();
}

TEST(Messages, FluidInAWall) {
  expectMessage(shaftWith("region = \"gap\"", "region = \"housing\""),
                {"wall[0].region = \"shaft\"", "241 of", "(0, 0)", "0.04 m behind",
                 "{ difference = [\"housing\", \"shaft\"] }"});
}

TEST(Messages, OverlapsAndExactMasses) {
  expectMessage(
      shaftWith("[[wall]]", "[[fluid]]\nregion = \"housing\"\nmass = \"exact\"\n[[wall]]"),
      {"fluid[1].mass = \"exact\"", "overlaps", "difference"});
  expectMessage(shaftWith("[[wall]]", "[[fluid]]\nname = \"b\"\nregion = \"gap\"\n[[wall]]"),
                {"fluid[1].region", "earlier fluids cover all of it"});
}

TEST(Messages, PeriodicAxes) {
  const std::string domain = R"(
dimension = 2
spacing = 0.1
[domain]
lower = [0, 0]
upper = [0.5, 1]
periodic = ["x", "y"]
[[fluid]]
)";
  expectMessage(domain, {"domain", "periodic axis x is 0.5 m", "support of 0.3 m"});
  std::string open = domain;
  open.replace(open.find("0.5, 1"), 6, "2.0, 1").replace(open.find(", \"y\""), 5, "");
  expectMessage(open, {"fluid[0]", "axis y is not periodic", "name a region"});
  std::string third = domain;
  third.replace(third.find("\"y\""), 3, "\"z\"");
  third.replace(third.find("0.5, 1"), 6, "2.0, 1");
  expectMessage(third, {"periodic", "no axis \"z\""});
}

TEST(Messages, AThinWallIsWarnedOf) {
  std::vector<std::string> warnings;
  test::sceneOf<2>(shaftWith("layers = 4", "layers = 2"), &warnings);
  ASSERT_EQ(warnings.size(), 1u);
  for (const char* part : {"wall \"housing\" has 2 layers", "needs 3", "refuse", "set it to 3"})
    EXPECT_NE(warnings[0].find(part), std::string::npos) << warnings[0];
}

}  // namespace
}  // namespace plenum
