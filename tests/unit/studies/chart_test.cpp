// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/chart.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace plenum::study {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string textOf(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

Chart someChart() {
  return {"Bob's \"chart\" of a_b & <c>",
          {"cost [s]", true, {}, {}},
          {"error [%]", true, {}, {}},
          {{"convex", SeriesStyle::points, {{1, 2, "first & <best>"}, {3, 0.5, "second"}}, false},
           {"front", SeriesStyle::line, {{1, 2, ""}, {3, 0.5, ""}}, true}}};
}

TEST(Charts, ShowLabelsWithoutScripts) {
  const std::string svg = svgOf(someChart(), "one");
  EXPECT_TRUE(svg.starts_with("<svg"));
  EXPECT_THAT(svg, HasSubstr("<title>first &amp; &lt;best></title>"));
  EXPECT_THAT(svg, HasSubstr("<title>second</title>"));
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  EXPECT_THAT(svg, Not(HasSubstr("onmousemove")));
}

/// The labels on the horizontal axis from `lowest` to `highest`.
std::string svgWithCosts(double lowest, double highest) {
  Chart chart = someChart();
  chart.series = {{"", SeriesStyle::points, {{lowest, 1, ""}, {highest, 2, ""}}, false}};
  return svgOf(chart, "one");
}

TEST(Charts, ShowMarksInLabels) {
  Chart chart = someChart();
  chart.series[0].points[0].label = "Bob's \"best\" \\ one";
  const std::string svg = svgOf(chart, "one");
  EXPECT_THAT(svg, HasSubstr("<title>Bob\u2019s \u201dbest\u201d   one</title>"));
  EXPECT_THAT(svg, Not(HasSubstr("onmousemove")));
}

TEST(Charts, HaveRoundNumbersOnTheirAxes) {
  for (const char* number : {">0.1<", ">0.2<", ">0.5<", ">1<"})
    EXPECT_THAT(svgWithCosts(0.08, 1.2), HasSubstr(number));
  for (const char* number : {">1.2<", ">1.4<", ">1.6<"})
    EXPECT_THAT(svgWithCosts(1.05, 1.7), HasSubstr(number));
  EXPECT_THAT(svgWithCosts(0.54321, 0.54321), HasSubstr(">0.543<"));
}

TEST(Charts, NameThePlaceOfZeroOnALogarithmicAxis) {
  Chart chart = someChart();
  chart.y.zero = 0.1;
  chart.series[0].points.push_back({2, 0.1, ""});
  EXPECT_THAT(svgOf(chart, "one"), HasSubstr(">0<"));
  EXPECT_THAT(svgOf(someChart(), "one"), Not(HasSubstr(">0<")));
}

TEST(Charts, OfOnePageHaveNoNameInCommon) {
  EXPECT_THAT(svgOf(someChart(), "one"), HasSubstr("id=\"one_"));
  EXPECT_THAT(svgOf(someChart(), "two"), Not(HasSubstr("id=\"one_")));
}

TEST(Charts, AreWrittenAsPictures) {
  const test::TemporaryFolder folder;
  writeChart(folder / "chart", someChart());
  EXPECT_TRUE(textOf(folder / "chart.png").starts_with("\x89PNG"));
  EXPECT_THAT(textOf(folder / "chart.svg"), HasSubstr("</svg>"));
}

TEST(HeatMaps, HaveTheirTextsAndLeaveHoles) {
  const HeatMap map{"map",
                    "row",
                    "column",
                    "value",
                    {"a_1", "b"},
                    {"1", "2"},
                    {{0, 1}, {std::nan(""), 0.5}},
                    {{"zero", "one"}, {"", "half"}},
                    0,
                    1};
  const std::string svg = svgOf(map, "map");
  for (const char* text : {"zero", "one", "half", "a_1"}) EXPECT_THAT(svg, HasSubstr(text));
}

TEST(HeatMaps, MayBeEmptyOrAllTheSame) {
  HeatMap map{"map", "row", "column", "value", {"a"}, {"1"}, {{std::nan("")}}, {}, {}, {}};
  EXPECT_THAT(svgOf(map, "map"), HasSubstr("</svg>"));
  map.values = {{0}};
  EXPECT_THAT(svgOf(map, "map"), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace plenum::study
