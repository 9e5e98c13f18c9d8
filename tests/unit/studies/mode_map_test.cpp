// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/mode_map.hpp"

#include "particles/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plenum::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ModeMaps, NameRowsByWhatDiffers) {
  const std::vector<std::string> two{"wendland_c2", "convex"};
  const HeatMap ofKernels = heatMapOf(computeModes("hexagonal", {1}, two, {1.2}));
  EXPECT_THAT(ofKernels.rows, ElementsAre("wendland_c2", "convex"));
  EXPECT_THAT(ofKernels.title, HasSubstr("p0 = 1 "));
  const HeatMap ofPressures = heatMapOf(computeModes("hexagonal", {1, 0.5}, {"convex"}, {1.2}));
  EXPECT_THAT(ofPressures.rows, ElementsAre("1", "0.5"));
  EXPECT_THAT(ofPressures.title, HasSubstr("convex"));
  const HeatMap ofBoth = heatMapOf(computeModes("hexagonal", {1, 0.5}, two, {1.2}));
  EXPECT_THAT(ofBoth.rows,
              ElementsAre("wendland_c2 1", "wendland_c2 0.5", "convex 1", "convex 0.5"));
}

// Swegle, Hicks & Attaway (1995, doi 10.1006/jcph.1995.1010): under tension waves grow where W'' is
// positive at the neighbours, as it is for all kernels here. But a pair also resists sideways, by
// |W'|/r, which for the kernel of Schuessler & Schmitt, -sqrt(r), is twice W'': its lattice stands.
TEST(ModeMaps, GrowUnderTensionUnlessPairsResistSideways) {
  for (const ModeRow& row : computeModes("hexagonal", {-0.1}, KernelId::names(), {1.2}).rows) {
    if (row.kernel == KernelId::named("schuessler_schmitt"))
      EXPECT_GT(row.cells[0].omegaSquared, 0);
    else
      EXPECT_LT(row.cells[0].omegaSquared, -1e-3) << row.kernel.name();  // the slowest: -.0375
  }
}

// Under pressure the same lattice of wendland_c2 stands; so the sign is that of the pressure.
TEST(ModeMaps, ThePressureDecides) {
  const ModeMap map = computeModes("hexagonal", {-0.1, 0, 1}, {"wendland_c2"}, {1.2});
  EXPECT_LT(map.rows[0].cells[0].omegaSquared, -1e-3);
  EXPECT_GT(map.rows[2].cells[0].omegaSquared, -1e-12);  // rounding
}

TEST(ModeMaps, RefuseWhatDoesNotExist) {
  EXPECT_THROW(computeModes("hexagonal", {1}, {"wendland"}, {1.2}), InputError);
  EXPECT_THROW(computeModes("pentagonal", {1}, {"convex"}, {1.2}), InputError);
}

}  // namespace
}  // namespace plenum::study
