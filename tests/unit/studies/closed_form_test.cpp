// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/closed_form.hpp"

#include <gtest/gtest.h>

namespace plenum::study {
namespace {

CaseSettings caseNamed(const std::string& name) {
  return readCase(CaseNode::load(std::string(PLENUM_SOURCE_DIR) + "/cases/" + name));
}

/// Values of a program of its own, to their last digit.
TEST(HydrostaticColumn, HasTheErrorsOfItsKernels) {
  const auto column = HydrostaticColumn::of(caseNamed("hydrostatic_tank.toml"));
  ASSERT_TRUE(column);
  EXPECT_NEAR(column->error("wendland_c2_1d", 1.5), 1.316, 5e-4);
  EXPECT_NEAR(column->error("wendland_c2_1d", 2.0), 0.484, 5e-4);
  EXPECT_NEAR(column->error("convex", 1.5), 2.750, 5e-4);
  EXPECT_NEAR(column->error("convex", 2.0), 1.181, 5e-4);
  EXPECT_NEAR(column->error("wendland_c2", 1.5), 1.359, 5e-4);
  EXPECT_NEAR(column->error("wendland_c2", 2.0), 0.759, 5e-4);
}

/// Many neighbours: the lattice becomes a continuum, and only the compression is left,
/// g H/(2 c^2) = .545 %.
TEST(HydrostaticColumn, TendsToTheCompressionOfTheColumn) {
  const auto column = HydrostaticColumn::of(caseNamed("hydrostatic_tank.toml"));
  EXPECT_NEAR(column->error("wendland_c2", 6), 0.545, 1e-3);
}

TEST(HydrostaticColumn, IsNoOtherCase) {
  for (const char* other : {"gas_box.toml", "dam_break_single.toml", "sod.toml"})
    EXPECT_FALSE(HydrostaticColumn::of(caseNamed(other))) << other;
}

}  // namespace
}  // namespace plenum::study
