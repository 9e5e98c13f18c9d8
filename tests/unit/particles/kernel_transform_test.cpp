// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/kernel_transform.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum {
namespace {

TEST(KernelTransform, IsOneAtZero) {
  for (const std::string& name : KernelId::names())
    for (int dim = 1; dim <= 3; ++dim)
      // Quadrature: sqrt(R) at R = 0 is the least smooth.
      EXPECT_NEAR(kernelTransform(KernelId::named(name), dim, 0), 1, 1e-9) << name << " " << dim;
}

TEST(KernelTransform, OfTheCubicSplineInOneDimensionIsTheFourthPowerOfSinc) {
  for (const double k : {0.3, 2.0, 7.7, 31.0}) {
    const double sinc = std::sin(k / 2) / (k / 2);
    EXPECT_NEAR(kernelTransform(KernelId::named("cubic_spline"), 1, k), std::pow(sinc, 4), 1e-12);
  }
}

/// First negative k h and lowest value relative to that at zero; 0: never.
struct Row {
  const char* kernel;
  double first[3];
  double lowest[3];
};

/// Computed apart from this code with other quadrature: Hankel transforms to three digits.
constexpr Row rows[] = {
    {"cubic_spline", {0, 5.69, 6.29}, {0, -6.4e-4, -6.0e-4}},
    {"quartic_liu", {17.61, 5.08, 4.98}, {-1.0e-5, -3.3e-4, -2.8e-3}},
    {"quartic_spline", {7.96, 10.45, 11.23}, {-4.8e-4, -1.9e-4, -7.9e-5}},
    {"quintic_spline", {0, 8.37, 9.58}, {0, -2.5e-5, -2.2e-5}},
    {"wendland_c2", {0, 0, 0}, {}},
    {"wendland_c4", {0, 0, 0}, {}},
    {"wendland_c6", {0, 0, 0}, {}},
    {"wendland_c2_1d", {0, 7.89, 4.78}, {0, -6.4e-5, -1.7e-3}},
    {"wendland_quadratic", {3.14, 3.39, 3.66}, {-2.2e-2, -1.9e-2, -1.5e-2}},
    {"convex", {0, 0, 0}, {}},
    {"johnson_beissel", {0, 0, 0}, {}},
    {"core_triangle", {0, 0, 0}, {}},
    {"schuessler_schmitt", {0, 0, 3.42}, {0, 0, -8.3e-3}},
};

TEST(KernelTransform, TurnsNegativeWhereItShould) {
  for (const Row& row : rows)
    for (int dim = 1; dim <= 3; ++dim) {
      const TransformSign sign = transformSign(KernelId::named(row.kernel), dim);
      const double first = row.first[dim - 1], lowest = row.lowest[dim - 1];
      EXPECT_EQ(sign.isNegative, first > 0) << row.kernel << " " << dim;
      if (first == 0) continue;
      // The table is rounded, and was sampled coarsely where splines have zeros of high order.
      EXPECT_LT(sign.firstNegative, first + 0.006) << row.kernel << " " << dim;
      EXPECT_GT(sign.firstNegative, first - 0.06) << row.kernel << " " << dim;
      EXPECT_NEAR(sign.lowest / lowest, 1, 0.05) << row.kernel << " " << dim;  // two digits
    }
}

}  // namespace
}  // namespace plenum
