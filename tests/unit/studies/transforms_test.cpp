// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/transforms.hpp"

#include "particles/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace plenum::study {
namespace {

/// k h of the first zero by another program's quadrature, in 1, 2 and 3 dimensions; 0: never.
const std::map<std::string, std::array<double, 3>> firstZeros{
    {"cubic_spline", {0, 5.69, 6.29}},
    {"quartic_liu", {17.61, 5.08, 4.98}},
    {"quartic_spline", {7.96, 10.45, 11.23}},
    {"quintic_spline", {0, 8.37, 9.58}},
    {"wendland_c2", {0, 0, 0}},
    {"wendland_c4", {0, 0, 0}},
    {"wendland_c6", {0, 0, 0}},
    {"wendland_c2_1d", {0, 7.89, 4.78}},
    {"wendland_quadratic", {3.14, 3.39, 3.66}},
    {"convex", {0, 0, 0}},
    {"johnson_beissel", {0, 0, 0}},
    {"core_triangle", {0, 0, 0}},
    {"schuessler_schmitt", {0, 0, 3.42}}};

/// Zeros of splines in the dimensions in which they are convolutions, or derivatives of those, are
/// of fifth order: how soon the transform is below a threshold depends on that. Here it is -1e-10,
/// in the other program -1e-9.
bool isFlat(const std::string& kernel, std::size_t dimension) {
  return (kernel == "quartic_spline" && dimension == 1) ||
         (kernel == "quintic_spline" && dimension == 3);
}

/// sinc^5(2 k h/5) falls below -1e-10 when (2 k h/5)/pi - 1 is above the fifth root of that.
TEST(Transforms, HaveTheZeroOfTheQuarticSplineInOneDimension) {
  EXPECT_NEAR(transformsOf({"quartic_spline"})[0].sign[0].firstNegative,
              2.5 * kernel::pi * (1 + 0.01), 2e-3);
}

/// Stated to two decimals.
TEST(Transforms, HaveTheSignsAndZerosOfAnotherProgram) {
  const auto transforms = transformsOf({});
  ASSERT_EQ(transforms.size(), firstZeros.size());
  for (const KernelTransforms& kernel : transforms)
    for (std::size_t d = 0; d < 3; ++d) {
      const double expected = firstZeros.at(kernel.kernel)[d];
      EXPECT_EQ(kernel.sign[d].isNegative, expected > 0) << kernel.kernel << " " << d + 1;
      if (expected > 0) {
        EXPECT_NEAR(kernel.sign[d].firstNegative, expected,
                    isFlat(kernel.kernel, d + 1) ? 0.04 : 0.01)
            << kernel.kernel << " " << d + 1;
      }
    }
}

TEST(Transforms, SayWhichWavesALatticeCarries) {
  const TransformSign sign = transformsOf({"wendland_c2_1d"})[0].sign[1];
  // 2 pi 1.5 / 7.89 of a spacing: too short for a lattice; at 3 d_ref it is longer than two.
  EXPECT_NEAR(firstNegativeWavelength(sign, 1.5), 1.195, 0.002);
  EXPECT_GT(firstNegativeWavelength(sign, 3), 2);
  EXPECT_TRUE(std::isnan(firstNegativeWavelength(transformsOf({"convex"})[0].sign[1], 3)));
}

TEST(Transforms, RefuseUnknownKernels) { EXPECT_THROW(transformsOf({"convx"}), InputError); }

}  // namespace
}  // namespace plenum::study
