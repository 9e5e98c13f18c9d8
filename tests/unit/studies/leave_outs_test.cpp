// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/leave_outs.hpp"

#include "ictools/check.hpp"
#include "particles/atomic_file.hpp"
#include "particles/case_settings.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plenum::study {
namespace {

CaseNode caseNamed(const std::string& name) {
  return CaseNode::load(std::string(PLENUM_SOURCE_DIR) + "/cases/" + name);
}

std::vector<std::string> namesOf(const std::vector<LeaveOut>& all) {
  std::vector<std::string> names;
  for (const LeaveOut& one : all) names.push_back(one.what);
  return names;
}

TEST(LeaveOuts, AreTheSecondFluidAndOptionalTerms) {
  const CaseNode dam = caseNamed("dam_break_multiphase.toml");
  const auto all = leaveOutsOf(dam);
  EXPECT_THAT(namesOf(all), testing::IsSupersetOf({"the fluid air", "collisions", "viscosity"}));
  EXPECT_EQ(dam.find("fluid")->asArray().size(), 2u);
  EXPECT_EQ(all[0].root.find("fluid")->asArray().size(), 1u);
  // Which a single fluid has no field for.
  EXPECT_EQ(dam.find("output")->find("picture")->asString(), "material");
  EXPECT_EQ(all[0].root.find("output")->find("picture"), nullptr);
}

/// What is left out is out of the printed file, too, and plenum-ic takes it.
TEST(LeaveOuts, MakeAPlaneOfAUniformScene) {
  const auto all = leaveOutsOf(caseNamed("dam_break_3d.toml"));
  ASSERT_EQ(all[0].what, "the third dimension, along y");
  const test::TemporaryFolder folder;
  writeTextFile(folder / "flat.toml", all[0].root.printedFile("flat"));
  const CheckReport report = checkCase(folder / "flat.toml", {});
  EXPECT_FALSE(report.findings.hasErrors()) << describe(report);
  const CaseSettings settings = readCase(CaseNode::load(folder / "flat.toml"));
  EXPECT_EQ(settings.dimension, 2);
  EXPECT_EQ(settings.solverOrDefaults().gravity, (std::vector<double>{0, -9.81}));
  EXPECT_EQ(settings.measuresOrDefaults().gauges.at(1).point, std::vector<double>{0.4});
  EXPECT_EQ(settings.validations.at(0).curve->times.size(), 6u);  // no vectors
}

TEST(LeaveOuts, AreNoneWhereNothingIsOptional) {
  EXPECT_TRUE(leaveOutsOf(CaseNode::parse("dimension = 2\nfluid = [{}]\n[solver]\n", "x")).empty());
}

}  // namespace
}  // namespace plenum::study
