// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/check.hpp"
#include "particles/memory.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/ictools/scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

namespace plenum {
namespace {

CheckReport checkText(const std::string& text, const std::vector<std::string>& settings = {}) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "case.toml") << text;
  return checkCase(folder.path() / "case.toml", settings);
}

std::string box(double lower, double upper, const std::string& more = "") {
  return fmt::format(
             "dimension = 2\nspacing = 0.1\n[geometry]\nbox = {{ box = {{ lower = [{0}, {0}], "
             "upper = "
             "[{1}, {1}] }} }}\n[[fluid]]\nregion = \"box\"\n",
             lower, upper) +
         more;
}

/// One finding of this severity with these words, and no other.
void expectOne(const CheckReport& report, Severity severity,
               const std::vector<std::string>& words) {
  ASSERT_EQ(report.findings.all().size(), 1u) << describe(report);
  const Finding& finding = report.findings.all()[0];
  EXPECT_EQ(finding.severity, severity);
  EXPECT_FALSE(finding.remedy.empty());
  for (const std::string& word : words)
    EXPECT_NE(finding.text().find(word), std::string::npos) << word << "\n" << finding.text();
}

TEST(Check, CountsWhatGenerateMakes) {
  const CheckReport report = checkText(test::shaftCase());
  EXPECT_TRUE(report.findings.all().empty()) << describe(report);
  const auto scene = test::sceneOf<2>(test::shaftCase());
  ASSERT_TRUE(report.estimate);
  EXPECT_TRUE(report.estimate->isCounted);
  EXPECT_EQ(report.estimate->nFluid, static_cast<double>(scene.particles.nFluid()));
  EXPECT_EQ(report.estimate->nWalls, static_cast<double>(scene.particles.nWalls()));
  // pi 3^2 / (sqrt(3)/2) - 1: hexagonal, support of 3 d_ref
  EXPECT_NEAR(report.estimate->neighbours, 31.65, 0.01);
}

TEST(Check, ExpectsWhatIsTooManyToCount) {
  const std::string spacing = "spacing=0.0001";
  const CheckReport report = checkText(test::shaftCase(), {spacing});
  expectOne(report, Severity::note, {"more than", "--set spacing"});
  ASSERT_TRUE(report.estimate);
  EXPECT_FALSE(report.estimate->isCounted);
  const double expected = M_PI * (0.01 - 0.0016) / (std::sqrt(0.75) * 1e-8);
  EXPECT_NEAR(report.estimate->nFluid / expected, 1, 1e-9);  // the same formula
  // Bands of 8 and 4 spacings; 20000 places see a band of 1 % of the box to 1/sqrt(200) = 7 %.
  const double bands = M_PI * (0.04 * 0.04 - 0.0392 * 0.0392 + 0.1004 * 0.1004 - 0.01);
  EXPECT_NEAR(report.estimate->nWalls / (bands / (std::sqrt(0.75) * 1e-8)), 1, 0.21);  // 3 of them
}

TEST(Check, FindsNarrowGaps) {
  const std::string slot =
      "dimension = 2\nspacing = 0.1\n[geometry]\nslot = { box = { lower = [0, 0], upper = [3, "
      "0.14] "
      "} }\n[[fluid]]\nregion = \"slot\"\n";
  expectOne(checkText(slot), Severity::warning,
            {"0.14 m or 1.4 d_ref wide", "needs 3 d_ref", "refine the spacing to 0.0467 m"});
  EXPECT_TRUE(checkText(slot, {"spacing=0.0466"}).findings.all().empty());
}

TEST(Check, SizesThatLookLikeAnotherUnit) {
  std::string text = box(0, 1);  // and a part that nobody fills
  text.insert(text.find("[[fluid]]"), "hull = { disk = { center = [0, 0], radius = 5e3 } }\n");
  expectOne(checkText(text), Severity::warning, {"geometry.hull", "1e+05 spacings", "unit"});
  const CheckReport tiny = checkText(box(0, 0.25));
  ASSERT_FALSE(tiny.findings.all().empty());
  EXPECT_NE(tiny.findings.all()[0].what.find("2.5 spacings"), std::string::npos);
  EXPECT_TRUE(checkText(box(0, 1)).findings.all().empty());
}

TEST(Check, DistanceFromTheOrigin) {
  expectOne(
      checkText(box(30000, 30001)), Severity::warning,
      {"3e+04 m from the origin", "0.0036 m or 0.036 d_ref", "translate = [-30000.5, -30000.5]"});
  EXPECT_TRUE(checkText(box(300, 301)).findings.all().empty());  // 4e-5 m: nobody sees it
}

TEST(Check, AllFaultsOfACase) {
  const std::string text =
      "dimension = 2\nspacing = 0.1\n[geometry]\n"
      "one = { file = \"none.wkt\" }\ntwo = { union = [\"one\", \"three\"] }\n"
      "three = { disk = { center = [0, 0], radius = -1 } }\n"
      "four = { disk = { center = [0, 0], radius = 1 } }\n"
      "[[fluid]]\nregion = \"four\"\npressure = 1\n[[fluid]]\nregion = \"two\"\n"
      "[[wall]]\nregion = \"five\"\n";
  const CheckReport report = checkText(text);
  const auto& all = report.findings.all();
  ASSERT_EQ(all.size(), 3u) << describe(report);  // `two` and its fluid only follow
  EXPECT_NE(all[0].what.find("no such file"), std::string::npos);
  EXPECT_NE(all[1].what.find("radius = -1"), std::string::npos);
  EXPECT_NE(all[2].what.find("\"five\""), std::string::npos);
  EXPECT_FALSE(report.estimate);
}

TEST(Check, FluidInTwoWallsIsTwoFindings) {
  const std::string walls =
      "left = { box = { lower = [0, 0], upper = [0.5, 2] } }\n"
      "right = { box = { lower = [1.5, 0], upper = [2, 2] } }\n";
  std::string text = box(0, 2, "[[wall]]\nregion = \"left\"\n[[wall]]\nregion = \"right\"\n");
  text.insert(text.find("[[fluid]]"), walls);
  const CheckReport report = checkText(text);
  ASSERT_EQ(report.findings.count(Severity::error), 2u) << describe(report);
  for (const Finding& finding : report.findings.all()) EXPECT_EQ(finding.place.size(), 2u);
}

TEST(Check, MoreThanTheMemoryIsRefused) {
  // 1e5 x 2e4 spacings: below 2^31 particles; 190 bytes each are 440 GB.
  const std::string huge =
      "dimension = 2\nspacing = 0.001\n[geometry]\nbox = { box = { lower = [0, 0], upper = [100, "
      "18] "
      "} }\n[[fluid]]\nregion = \"box\"\nlattice = \"square\"\n";
  const auto available = availableMemory();
  if (!available || *available > 300e9) GTEST_SKIP() << "a machine with more memory than that";
  const CheckReport report = checkText(huge);
  ASSERT_EQ(report.findings.count(Severity::error), 1u) << describe(report);
  EXPECT_NE(describe(report).find("are available"), std::string::npos);
  EXPECT_NE(test::messageOf<2>(huge).find("are available"), std::string::npos);
}

TEST(Check, JsonHoldsAll) {
  const std::string json = toJson(checkText(box(30000, 30001)));
  for (const char* word : {"\"sound\": true", "\"severity\": \"warning\"", "\"place\": [",
                           "\"remedy\": \"move", "\"extent_in_spacings\"", "\"run_bytes\""})
    EXPECT_NE(json.find(word), std::string::npos) << word << json;
}

}  // namespace
}  // namespace plenum
