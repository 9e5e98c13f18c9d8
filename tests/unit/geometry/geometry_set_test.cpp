// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/geometry_set.hpp"
#include "particles/errors.hpp"
#include "tests/support/named_region.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace plenum {
namespace {

CaseNode tableOf(const std::string& text) {
  return *CaseNode::parse("[geometry]\n" + text, "case.toml").find("geometry");
}

template <int Dim>
GeometrySet<Dim> read(const std::string& text) {
  return GeometrySet<Dim>::read(tableOf(text), ".");
}

/// The message of the InputError that reading `text` throws.
template <int Dim>
std::string errorOf(const std::string& text) {
  try {
    read<Dim>(text);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no error: " << text;
  return "";
}

void expectHas(const std::string& message, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' in: " << message;
}

TEST(GeometrySet, ReadsTheShaft) {
  const auto set = read<2>(R"(
gap     = { difference = ["housing", "shaft"] }
shaft   = { disk = { center = [0, 0], radius = 0.04 } }
housing = { disk = { center = [0, 0], radius = 0.10 } }
)");
  const GeometryPtr<2> gap = test::regionNamed(set, "gap");
  EXPECT_NEAR(gap->volume().value, std::numbers::pi * (0.01 - 0.0016), 1e-15);
  EXPECT_TRUE(gap->isInside(Vec<2>{{0.07, 0}}));
  EXPECT_FALSE(gap->isInside(Vec<2>{{0.03, 0}}));
}

TEST(GeometrySet, ReadsEveryShape) {
  const auto flat = read<2>(R"(
a = { box = { lower = [0, 0], upper = [1, 2] } }
b = { disk = { center = [0, 0], radius = 1 } }
c = { annulus = { center = [0, 0], inner_radius = 1, outer_radius = 2 } }
d = { half_space = { point = [0, 0], normal = [0, 2] } }
f = { union = ["a", "b"] }
g = { intersection = ["b", "d"] }
)");
  for (const char* name : {"a", "b", "c", "d", "f", "g"})
    EXPECT_EQ(test::regionNamed(flat, name)->isInside(Vec<2>{{0.5, 1.2}}),
              std::string("acf").find(name) != std::string::npos)
        << name;
  const auto solid = read<3>(R"(
a = { box = { lower = [0, 0, 0], upper = [1, 2, 3] } }
b = { ball = { center = [0, 0, 0], radius = 1 } }
c = { cylinder = { from = [0, 0, 0], to = [0, 0, 2], radius = 0.5 } }
)");
  EXPECT_DOUBLE_EQ(test::regionNamed(solid, "a")->volume().value, 6);
  EXPECT_DOUBLE_EQ(test::regionNamed(solid, "c")->volume().value, std::numbers::pi / 2);
  const auto line = read<1>("a = { box = { lower = [0], upper = [1.5] } }");
  EXPECT_DOUBLE_EQ(test::regionNamed(line, "a")->volume().value, 1.5);
}

TEST(GeometrySet, PlacesShapes) {
  const auto flat = read<2>(R"(
a = { box = { lower = [0, 0], upper = [2, 1] }, scale = 2, rotate = 90, translate = [10, 0] }
b = { union = ["a"], translate = [0, 1] }
)");
  EXPECT_TRUE(test::regionNamed(flat, "a")->isInside(Vec<2>{{9, 3}}));
  EXPECT_FALSE(test::regionNamed(flat, "a")->isInside(Vec<2>{{9, -0.5}}));
  EXPECT_TRUE(test::regionNamed(flat, "b")->isInside(Vec<2>{{9, 4.5}}));
  const auto solid = read<3>(R"(
a = { box = { lower = [0, 0, 0], upper = [2, 1, 1] }, rotate = { axis = [0, 0, 1], angle = 90 } }
)");
  EXPECT_TRUE(test::regionNamed(solid, "a")->isInside(Vec<3>{{-0.5, 1.5, 0.5}}));
}

TEST(GeometrySet, NamesTheNearestRegion) {
  const std::string shaft = "shaft = { disk = { center = [0, 0], radius = 0.04 } }\n";
  expectHas(errorOf<2>(shaft + "gap = { difference = [\"shaft\", \"shafr\"] }"),
            {"case.toml:3", "shafr", "did you mean \"shaft\""});
  const auto set = read<2>(shaft);
  const CaseNode region = *CaseNode::parse("region = 'shat'", "case.toml").find("region");
  try {
    set.find(region);
    FAIL();
  } catch (const InputError& error) {
    expectHas(error.what(), {"case.toml:1", "region", "did you mean \"shaft\""});
  }
}

TEST(GeometrySet, RefusesCircles) {
  expectHas(errorOf<2>("a = { union = [\"b\"] }\nb = { union = [\"a\"] }"),
            {"refers to itself", "a -> b -> a"});
}

TEST(GeometrySet, RefusesShapesOfAnotherDimension) {
  expectHas(errorOf<3>("a = { disk = { center = [0, 0], radius = 1 } }"),
            {"case.toml:2", "disk", "3-D", "use ball or cylinder"});
  expectHas(errorOf<2>("a = { ball = { center = [0, 0, 0], radius = 1 } }"), {"use disk"});
  expectHas(errorOf<2>("a = { cylinder = { radius = 1 } }"), {"use disk"});
  expectHas(errorOf<1>("a = { file = \"a.wkt\" }"), {"use box"});
  expectHas(errorOf<2>("a = { box = { lower = [0, 0, 0], upper = [1, 1] } }"),
            {"3 components", "2 dimensions"});
}

TEST(GeometrySet, RefusesWhatSaysNothingOrTooMuch) {
  expectHas(errorOf<2>("a = { translate = [0, 0] }"), {"give one of", "disk"});
  expectHas(errorOf<2>("a = { dis = { center = [0, 0] } }"),
            {"unknown key", "did you mean 'disk'"});
  expectHas(errorOf<2>("a = { disk = { center = [0, 0], radius = 1 }, file = 'a.wkt' }"),
            {"already a disk"});
  expectHas(errorOf<2>("a = { disk = { center = [0, 0], raduis = 1 } }"),
            {"did you mean 'radius'"});
  expectHas(errorOf<2>("a = { disk = { center = [0, 0] } }"), {"'radius' is missing"});
}

TEST(GeometrySet, RefusesEmptyRegions) {
  expectHas(errorOf<2>("a = { disk = { center = [0, 0], radius = -1 } }"), {"must be > 0"});
  expectHas(errorOf<2>("a = { box = { lower = [0, 1], upper = [1, 1] } }"),
            {"is empty", "along y"});
  expectHas(errorOf<2>("a = { annulus = { center = [0, 0], inner_radius = 2, outer_radius = 1 } }"),
            {"is empty"});
  expectHas(errorOf<3>("a = { cylinder = { from = [0, 0, 0], to = [0, 0, 0], radius = 1 } }"),
            {"is empty"});
  expectHas(errorOf<2>("a = { half_space = { point = [0, 0], normal = [0, 0] } }"),
            {"no direction"});
  expectHas(errorOf<2>("a = { disk = { center = [0, 0], radius = 1 } }\n"
                       "b = { difference = [\"a\", \"a\"] }"),
            {"case.toml:3", "is empty"});
  expectHas(
      errorOf<2>("a = { disk = { center = [0, 0], radius = 1 } }\nb = { difference = ['a'] }"),
      {"two regions or more"});
}

TEST(GeometrySet, RefusesTransformsThatMeanNothing) {
  expectHas(errorOf<2>("a = { disk = { center = [0, 0], radius = 1 }, tolerance = 1 }"),
            {"files only"});
  expectHas(errorOf<2>("a = { disk = { center = [0, 0], radius = 1 }, rotate = { angle = 1 } }"),
            {"one number in 2-D"});
  expectHas(errorOf<3>("a = { ball = { center = [0, 0, 0], radius = 1 }, rotate = 30 }"), {"axis"});
}

TEST(GeometrySet, DocumentsEveryKey) {
  std::string text;
  for (const SectionDoc& doc : geometryDocs()) text += doc.printed();
  expectHas(text, {"disk", "half_space", "inner_radius", "difference", "file", "tolerance",
                   "rotate", "angle"});
}

}  // namespace
}  // namespace plenum
