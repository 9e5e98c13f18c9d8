// SPDX-License-Identifier: GPL-3.0-or-later
//
// [measures] and [[validate]]: what is refused when the case is read, whichever program reads it.
#include "particles/case_settings.hpp"
#include "particles/errors.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

/// The message of the error that this end of a case causes, or "no error".
std::string refusal(const std::string& text, int dimension = 2) {
  const std::string begin = "dimension = " + std::to_string(dimension) +
                            "\nspacing = 0.1\nfluid = [{ region = \"box\" }]\n";
  try {
    readCase(CaseNode::parse(begin + text, "case.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

#define EXPECT_REFUSED(text, part) \
  EXPECT_NE(refusal(text).find(part), std::string::npos) << refusal(text)

TEST(MeasureSettings, AllOfThem) {
  const std::string text = R"(
[measures]
free_surface = true
order = false
front = { axis = "y", direction = "-", material = "water" }
pressure_gradient = { middle = 0.5 }
taylor_green = { speed = 1, length = 2, viscosity = 0.01 }
couette = { center = [0, 0], inner_radius = 1, outer_radius = 2, inner_omega = 3 }
[[measures.probe]]
name = "p1"
point = [0, 1]
[[measures.probe]]
name = "p2"
point = [0, 2]
[[measures.gauge]]
name = "h1"
point = [0.5]
dry = 0
[[measures.volume]]
name = "v"
lower = [0, 0]
upper = [1, 1]
)";
  EXPECT_EQ(refusal(text), "no error");
  const MeasureSettings m =
      readCase(CaseNode::parse("spacing = 1\nfluid = []\n" + text, "f")).measuresOrDefaults();
  EXPECT_FALSE(m.order);
  ASSERT_EQ(m.probes.size(), 2u);
  EXPECT_EQ(m.probes[1].point, (std::vector<double>{0, 2}));
  EXPECT_EQ(m.gauges.at(0).dry, 0);
  EXPECT_EQ(m.front->direction, "-");
  EXPECT_EQ(m.volumes.at(0).upper, (std::vector<double>{1, 1}));
  EXPECT_EQ(m.pressureGradient->middle, 0.5);
  EXPECT_EQ(m.taylorGreen->length, 2);
  EXPECT_EQ(m.couette->bins, 10);
}

TEST(MeasureSettings, BadNamesAndPlaces) {
  EXPECT_REFUSED("measures = { probe = [{ name = \"p1\" }] }", "the key 'point' is missing");
  EXPECT_REFUSED("measures = { probe = [{ name = \"p,1\", point = [0, 0] }] }",
                 "measures.probe[0].name = \"p,1\": must be made of letters, digits and _");
  EXPECT_REFUSED("measures = { probe = [{ name = \"p1\", point = [0] }] }", "has 1 components");
  EXPECT_REFUSED(
      "measures = { probe = [{ name = \"a\", point = [0, 0] }], "
      "gauge = [{ name = \"a\", point = [0] }] }",
      "measures.gauge[0].name = \"a\": another measure has this name");
  EXPECT_REFUSED("measures = { gauge = [{ name = \"h\", point = [0, 0] }] }",
                 "measures.gauge[0].point: must have 1 component: the horizontal axes");
  EXPECT_NE(refusal("measures = { gauge = [{ name = \"h\", point = [] }] }", 1).find("no surface"),
            std::string::npos);
  EXPECT_REFUSED("measures = { volume = [{ name = \"v\", lower = [0, 1], upper = [1, 1] }] }",
                 "upper must be above lower on every axis");
  EXPECT_REFUSED("measures = { front = { axis = \"z\" } }", "a 2-D case has no such axis");
  EXPECT_REFUSED("measures = { pressure_gradient = { bottom = 1, surface = 1 } }",
                 "must not be at the bottom");
}

TEST(MeasureSettings, FlowsThatAreKnown) {
  EXPECT_NE(refusal("measures = { taylor_green = { speed = 1, length = 2, viscosity = 0 } }", 3)
                .find("is a flow in 2-D, the case is 3-D"),
            std::string::npos);
  EXPECT_REFUSED("measures = { taylor_green = { speed = 1, length = 2 } }",
                 "the key 'viscosity' is missing");
  EXPECT_REFUSED("measures = { couette = { inner_radius = 2, outer_radius = 2, inner_omega = 1 } }",
                 "must be above inner_radius");
  EXPECT_REFUSED("measures = { couette = { inner_radius = 1, outer_radius = 2 } }",
                 "one of inner_omega and outer_omega must not be zero");
}

std::string validateRefusal(const std::string& rest) {
  return refusal("[[validate]]\nquantity = \"max_speed\"\n" + rest);
}

#define EXPECT_VALIDATE_REFUSED(rest, part) \
  EXPECT_NE(validateRefusal(rest).find(part), std::string::npos) << validateRefusal(rest)

TEST(ValidateSettings, SoundOnes) {
  EXPECT_EQ(validateRefusal("expected = 1\ntolerance = 0.1"), "no error");
  EXPECT_EQ(validateRefusal("time = 1\nexpected = 1\nrelative_tolerance = 0.1"), "no error");
  EXPECT_EQ(validateRefusal("statistic = \"mean\"\nfrom = 1\nuntil = 2\nat_least = 0\nat_most = 1"),
            "no error");
  EXPECT_EQ(
      validateRefusal("curve = { times = [0, 1], values = [1, 2] }\nrelative_tolerance = 0.1"),
      "no error");
}

TEST(ValidateSettings, ExactlyOneExpectation) {
  const char* oneWay = "must say what is expected in one way";
  EXPECT_VALIDATE_REFUSED("", oneWay);
  EXPECT_VALIDATE_REFUSED("expected = 1\ntolerance = 1\nat_most = 1", oneWay);
  EXPECT_VALIDATE_REFUSED("expected = 1\ncurve = { times = [1], values = [1] }\ntolerance = 1",
                          oneWay);
  EXPECT_VALIDATE_REFUSED("expected = 1", "needs one of 'tolerance' and 'relative_tolerance'");
  EXPECT_VALIDATE_REFUSED("expected = 1\ntolerance = 1\nrelative_tolerance = 1", "needs one of");
  EXPECT_VALIDATE_REFUSED("at_most = 1\ntolerance = 1", "belongs to 'expected' or 'curve'");
  EXPECT_VALIDATE_REFUSED("at_most = 1\nat_least = 2", "must not be below at_least");
  EXPECT_VALIDATE_REFUSED("expected = 0\nrelative_tolerance = 1", "nothing is relative to zero");
  EXPECT_VALIDATE_REFUSED("expected = 1\ntolerance = -1", "tolerance = -1: must be >= 0");
}

TEST(ValidateSettings, TimesWhereTheyHaveAMeaning) {
  EXPECT_VALIDATE_REFUSED("statistic = \"at\"\nat_most = 1", "needs the key 'time'");
  EXPECT_VALIDATE_REFUSED("statistic = \"max\"\ntime = 1\nat_most = 1", "statistic = \"at\" only");
  EXPECT_VALIDATE_REFUSED("from = 1\nat_most = 1", "has a meaning for mean");
  EXPECT_VALIDATE_REFUSED("statistic = \"max\"\nfrom = 2\nuntil = 1\nat_most = 1",
                          "must be after from");
  EXPECT_VALIDATE_REFUSED("statistic = \"median\"\nat_most = 1", "must be one of at | last");
  EXPECT_VALIDATE_REFUSED(
      "statistic = \"max\"\ncurve = { times = [1], values = [1] }\ntolerance = 1",
      "leave this out");
}

TEST(ValidateSettings, Curves) {
  EXPECT_VALIDATE_REFUSED("curve = { times = [], values = [] }\ntolerance = 1",
                          "at least one time");
  EXPECT_VALIDATE_REFUSED("curve = { times = [1, 1], values = [1, 1] }\ntolerance = 1",
                          "must ascend");
  EXPECT_VALIDATE_REFUSED("curve = { times = [1, 2], values = [1] }\ntolerance = 1",
                          "has 1 entries for 2 times");
  EXPECT_VALIDATE_REFUSED("curve = { times = [1, 2], values = [1, 0] }\nrelative_tolerance = 1",
                          "nothing is relative to zero");
}

TEST(ValidateSettings, UnknownKeysAreErrors) {
  EXPECT_VALIDATE_REFUSED("at_mots = 1", "did you mean 'at_most'?");
}

}  // namespace
}  // namespace plenum
