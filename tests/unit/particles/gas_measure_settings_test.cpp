// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is refused of the measures of gases when the case is read, whichever program reads it.
#include "particles/errors.hpp"
#include "particles/measure_settings.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

MeasureSettings measuresOf(const std::string& text, int dimension = 2) {
  return measureSection().read(CaseNode::parse(text, "case.toml"), dimension);
}

std::string refusal(const std::string& text, int dimension = 2) {
  try {
    measuresOf(text, dimension);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

#define EXPECT_REFUSED(text, dimension, part) \
  EXPECT_NE(refusal(text, dimension).find(part), std::string::npos) << refusal(text, dimension)

TEST(GasMeasureSettings, AllOfThem) {
  const MeasureSettings m = measuresOf(R"(
riemann = { axis = "y", position = 1, left = { density = 1, velocity = 2, pressure = 3 }, right = { density = 4 }, window = [-1, 2], margin = 5 }
noh = { center = [1, 2], speed = 3, density = 4, radius = 5, within = 6 }
sedov = { center = [1, 2], energy = 3, density = 4 }
gresho = { center = [1, 2], radius = 3, speed = 4, drift = [5, 6] }
cloud = { density = 2, radius = 3, wind_density = 1, wind_internal_energy = 4, wind_speed = 5 }
)");
  EXPECT_EQ(m.riemann->axis, "y");
  EXPECT_EQ(m.riemann->left->pressure, 3);
  EXPECT_EQ(m.riemann->right->density, 4);
  EXPECT_FALSE(m.riemann->right->pressure);
  EXPECT_EQ(m.riemann->window, (std::vector<double>{-1, 2}));
  EXPECT_EQ(m.riemann->margin, 5);
  EXPECT_EQ(m.noh->within, 6);
  EXPECT_EQ(m.noh->radius, 5);
  EXPECT_EQ(m.sedov->energy, 3);
  EXPECT_EQ(m.gresho->drift, (std::vector<double>{5, 6}));
  EXPECT_EQ(m.cloud->windDensity, 1);
}

TEST(GasMeasureSettings, RiemannProblems) {
  const std::string sides = "left = { density = 1 }, right = { density = 1 }";
  EXPECT_REFUSED("riemann = { left = { density = 1 } }", 1, "the key 'right' is missing");
  EXPECT_REFUSED("riemann = { left = {}, right = { density = 1 } }", 1,
                 "the key 'density' is missing");
  EXPECT_REFUSED("riemann = { left = { density = 0 }, right = { density = 1 } }", 1,
                 "riemann.left.density = 0");
  EXPECT_REFUSED("riemann = { left = { density = 1, pressure = -1 }, right = { density = 1 } }", 1,
                 "riemann.left.pressure = -1");
  EXPECT_REFUSED("riemann = { axis = \"y\", " + sides + " }", 1, "a 1-D case has no such axis");
  EXPECT_REFUSED("riemann = { window = [1, 1], " + sides + " }", 1,
                 "the upper end must be above the lower one");
  EXPECT_REFUSED("riemann = { window = [1], " + sides + " }", 1, "window");
  EXPECT_REFUSED("riemann = { margin = -1, " + sides + " }", 1, "margin = -1");
}

TEST(GasMeasureSettings, OthersThatCannotBe) {
  EXPECT_REFUSED("noh = { speed = 0 }", 2, "noh.speed = 0");
  EXPECT_REFUSED("noh = { within = 0 }", 2, "noh.within = 0");
  EXPECT_REFUSED("sedov = { energy = 1 }", 2, "the key 'density' is missing");
  EXPECT_REFUSED("sedov = { energy = -1, density = 1 }", 2, "sedov.energy = -1");
  EXPECT_REFUSED("gresho = {}", 1, "a case of one dimension has no vortices");
  EXPECT_REFUSED("gresho = { drift = [1] }", 2, "has 1 components");
  EXPECT_REFUSED("gresho = { radius = 0 }", 2, "gresho.radius = 0");
  EXPECT_REFUSED("cloud = { density = 2 }", 3, "is missing");
  EXPECT_REFUSED(
      "cloud = { density = 1, radius = 3, wind_density = 1, wind_internal_energy = 4, wind_speed = "
      "5 }",
      3, "cloud.density = 1: must be above wind_density");
}

}  // namespace
}  // namespace plenum
