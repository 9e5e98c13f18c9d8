// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/pairing_forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum {
namespace {

using Verdict = PairingForecast::Verdict;

/// In 2-D by h/d_ref of a hexagonal lattice of d_ref = 1.
PairingForecast in2D(const char* kernel, double h) {
  return forecastPairing(KernelId::named(kernel), 2, h, std::sqrt(0.75));
}

/// In 3-D by the number of neighbours among particles of volume 1.
PairingForecast in3D(const char* kernel, double neighbours) {
  return forecastPairing(KernelId::named(kernel), 3,
                         0.5 * std::cbrt(3 * neighbours / (4 * kernel::pi)), 1);
}

TEST(PairingForecast, FollowsTransformAndMeasurementTogether) {
  EXPECT_EQ(in2D("wendland_c2", 3).verdict, Verdict::safe);
  EXPECT_EQ(in2D("convex", 2).verdict, Verdict::safe);
  EXPECT_EQ(in2D("quintic_spline", 1.5).verdict,
            Verdict::unpaired);  // negative, but few neighbours
  EXPECT_EQ(in2D("quintic_spline", 2).verdict, Verdict::pairs);
  EXPECT_EQ(in2D("wendland_c2_1d", 2).verdict, Verdict::pairs);
  EXPECT_EQ(in3D("cubic_spline", 40).verdict, Verdict::unpaired);
  EXPECT_EQ(in3D("cubic_spline", 80).verdict, Verdict::pairs);
  EXPECT_EQ(in3D("quartic_liu", 80).verdict, Verdict::unknown);
  EXPECT_EQ(forecastPairing(KernelId::named("cubic_spline"), 1, 1.5, 1).verdict, Verdict::safe);
}

TEST(PairingForecast, InterpolatesWhatWasMeasured) {
  EXPECT_NEAR(*in2D("wendland_c2_1d", 2).measuredShare, 0.21, 1e-12);
  EXPECT_NEAR(*in2D("wendland_c2_1d", 2.25).measuredShare, (0.21 + 0.46) / 2, 1e-12);
  EXPECT_NEAR(*in3D("cubic_spline", 72).measuredShare, (0.44 + 0.81) / 2, 1e-12);
  EXPECT_FALSE(in3D("wendland_c2_1d", 10).measuredShare);  // pairs at 32 already: below is unknown
  EXPECT_EQ(*in3D("cubic_spline", 10).measuredShare, 0);
  EXPECT_NEAR(in3D("cubic_spline", 72).neighbours, 72, 1e-9);
}

TEST(PairingForecast, SaysWhatToDo) {
  EXPECT_NE(in2D("cubic_spline", 2).text.find("choose wendland_c2"), std::string::npos);
}

}  // namespace
}  // namespace plenum
