// SPDX-License-Identifier: GPL-3.0-or-later
//
// All kernels: constants, normalisation, derivatives, ends. References are written down here once
// more, in the form in which the sources print them.
#include "particles/kernels.hpp"

#include "particles/errors.hpp"
#include "particles/vec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace plenum {
namespace {

constexpr double pi = std::numbers::pi;

/// Where a profile's pieces join (any of them), 0 and 2 included.
const std::vector<double> knots{0, 0.4, 2.0 / 3, 1, 1.2, 4.0 / 3, 2};

/// Abscissae and weights of 16-point Gauss-Legendre quadrature on [-1, 1] by Newton's method.
std::vector<std::pair<double, double>> gaussLegendre() {
  constexpr int n = 16;
  std::vector<std::pair<double, double>> rule;
  for (int k = 0; k < n; ++k) {
    double x = std::cos(pi * (k + 0.75) / (n + 0.5)), slope = 1;
    for (int pass = 0; pass < 100; ++pass) {
      double p0 = 1, p1 = x;
      for (int j = 2; j <= n; ++j)
        p0 = std::exchange(p1, ((2 * j - 1) * x * p1 - (j - 1) * p0) / j);
      slope = n * (x * p1 - p0) / (x * x - 1);
      x -= p1 / slope;
    }
    rule.emplace_back(x, 2 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

/// Integral of `f` over R in [0, 2] with R = u^2, which turns the square root of Schuessler &
/// Schmitt into a polynomial; between knots all integrands are then polynomials of degree < 32,
/// which the rule integrates exactly.
double integral(const std::function<double(double)>& f) {
  static const auto rule = gaussLegendre();
  double sum = 0;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double a = std::sqrt(knots[k]), b = std::sqrt(knots[k + 1]);
    for (const auto& [x, weight] : rule) {
      const double u = 0.5 * (a + b + (b - a) * x);
      sum += 0.5 * (b - a) * weight * 2 * u * f(u * u);
    }
  }
  return sum;
}

template <class Profile>
class KernelTest : public testing::Test {};
using Profiles =
    testing::Types<kernel::CubicSpline, kernel::QuarticLiu, kernel::QuarticSpline,
                   kernel::QuinticSpline, kernel::WendlandC2, kernel::WendlandC4,
                   kernel::WendlandC6, kernel::WendlandC2OneD, kernel::WendlandQuadratic,
                   kernel::Convex, kernel::SchuesslerSchmitt, kernel::JohnsonBeissel,
                   kernel::CoreTriangle>;
TYPED_TEST_SUITE(KernelTest, Profiles);

template <int Dim, class Profile>
double volumeIntegral(double h) {
  static constexpr std::array<double, 3> sphere{2, 2 * pi, 4 * pi};
  return integral([&](double R) {
    return sphere[Dim - 1] * std::pow(R * h, Dim - 1) * Kernel<Dim, Profile>::W(R * h, h) * h;
  });
}

TYPED_TEST(KernelTest, IsNormalisedInEveryDimension) {
  for (double h : {1.0, 0.37, 25.0}) {
    // 1e-9 is asked for; the rule is exact, so about a hundred roundings remain.
    EXPECT_NEAR((volumeIntegral<1, TypeParam>(h)), 1, 1e-13);
    EXPECT_NEAR((volumeIntegral<2, TypeParam>(h)), 1, 1e-13);
    EXPECT_NEAR((volumeIntegral<3, TypeParam>(h)), 1, 1e-13);
  }
}

TYPED_TEST(KernelTest, DerivativeIsThatOfTheProfile) {
  const auto f = [](double R) { return TypeParam::f(R); };
  const double e = 3e-4;
  for (double R = 0.05; R < 1.995; R += 0.0137) {
    // A stencil across a knot mixes two pieces.
    if (std::any_of(knots.begin(), knots.end(),
                    [&](double knot) { return std::fabs(R - knot) <= 2 * e; }))
      continue;
    const double slope = (8 * (f(R + e) - f(R - e)) - (f(R + 2 * e) - f(R - 2 * e))) / (12 * e);
    // Truncation e^4 f^(5)/30: at most 1e-9 (the square root at R = .05); rounding: 1e-16 f(0)/e,
    // where f(0) is up to 66.
    EXPECT_NEAR(TypeParam::g(R) * R, slope, 2e-9 + 1e-12 * f(0)) << R;
  }
}

TYPED_TEST(KernelTest, VanishesFromTwoOn) {
  EXPECT_EQ(TypeParam::f(2.0), 0);
  for (double R : {2.0 + 1e-12, 2.5, 100.0}) {
    EXPECT_EQ(TypeParam::f(R), 0) << R;
    EXPECT_EQ(TypeParam::g(R), 0) << R;
  }
  // Continuous at the end: there |f'| is at most .36 and |g'| at most 3 (wendland_quadratic).
  EXPECT_NEAR(TypeParam::f(2 - 1e-9), 0, 1e-9);
  if (TypeParam::name != "schuessler_schmitt") {  // its slope jumps at R = 2
    EXPECT_NEAR(TypeParam::g(2 - 1e-9), 0, 3.1e-9);
  }
}

TYPED_TEST(KernelTest, IsFiniteForCoincidentParticles) {
  const double h = 0.1;
  const double W = Kernel<3, TypeParam>::W(0, h), F = Kernel<3, TypeParam>::F(0, h);
  EXPECT_TRUE(std::isfinite(W) && W > 0);
  EXPECT_TRUE(std::isfinite(F));
  EXPECT_EQ(norm(F * Vec<3>{}), 0) << "no force between particles in one place, and no NaN";
}

TYPED_TEST(KernelTest, FallsMonotonically) {
  // Liu's quartic as printed dips below zero near the edge (from R = 1.8 on it rises again).
  const double end = TypeParam::name == "quartic_liu" ? 1.79 : 1.999;
  for (double R = 1e-3; R < end; R += 1e-3) EXPECT_LT(TypeParam::g(R), 0) << R;
}

TYPED_TEST(KernelTest, GradientPointsAlongThePair) {
  using K = Kernel<2, TypeParam>;
  const double h = 0.3, r = 0.25, e = 1e-5 * h;
  const double slope = (K::W(r + e, h) - K::W(r - e, h)) / (2 * e);
  // Central differences: e^2 f'''/6 relative to f', with e = 1e-5 h.
  EXPECT_NEAR(K::F(r, h) * r, slope, 1e-8 * std::fabs(slope));
}

/// f as the sources print it, and sigma in 1-D, 2-D and 3-D.
struct Row {
  std::function<double(double)> f;
  std::array<double, 3> sigma;
};

double cut(double a) { return a > 0 ? a : 0; }

std::map<std::string_view, Row> printedRows() {
  using std::pow, std::sqrt;
  const double s2 = std::sqrt(2.0), alpha = 1.0 / 3;
  std::map<std::string_view, Row> rows;
  rows["cubic_spline"] = {
      [](double R) { return R <= 1 ? 1 - 1.5 * R * R + 0.75 * R * R * R : pow(2 - R, 3) / 4; },
      {2.0 / 3, 10 / (7 * pi), 1 / pi}};
  rows["quartic_liu"] = {[](double R) {
                           return 2.0 / 3 - 9.0 / 8 * R * R + 19.0 / 24 * pow(R, 3) -
                                  5.0 / 32 * pow(R, 4);
                         },
                         {1, 15 / (7 * pi), 315 / (208 * pi)}};
  rows["quartic_spline"] = {[](double R) {
                              const double q = 1.25 * R;
                              return pow(2.5 - q, 4) - 5 * pow(cut(1.5 - q), 4) +
                                     10 * pow(cut(0.5 - q), 4);
                            },
                            {1.25 / 24, pow(1.25, 2) * 96 / (1199 * pi), pow(1.25, 3) / (20 * pi)}};
  rows["quintic_spline"] = {[](double R) {
                              const double q = 1.5 * R;
                              return pow(3 - q, 5) - 6 * pow(cut(2 - q), 5) +
                                     15 * pow(cut(1 - q), 5);
                            },
                            {1.5 / 120, pow(1.5, 2) * 7 / (478 * pi), pow(1.5, 3) / (120 * pi)}};
  rows["wendland_c2"] = {[](double R) { return pow(1 - R / 2, 4) * (1 + 2 * R); },
                         {3.0 / 4, 7 / (4 * pi), 21 / (16 * pi)}};
  rows["wendland_c4"] = {
      [](double R) { return pow(1 - R / 2, 6) * (35.0 / 12 * R * R + 3 * R + 1); },
      {27.0 / 32, 9 / (4 * pi), 495 / (256 * pi)}};
  rows["wendland_c6"] = {
      [](double R) { return pow(1 - R / 2, 8) * (4 * pow(R, 3) + 25.0 / 4 * R * R + 4 * R + 1); },
      {15.0 / 16, 39 / (14 * pi), 1365 / (512 * pi)}};
  rows["wendland_c2_1d"] = {[](double R) { return pow(2 - R, 3) * (1.5 * R + 1); },
                            {5.0 / 64, 5 / (32 * pi), 105 / (1024 * pi)}};
  rows["wendland_quadratic"] = {[](double R) { return pow(2 - R, 2) * (R + 1); },
                                {1.0 / 8, 5 / (24 * pi), 15 / (128 * pi)}};
  rows["convex"] = {[](double R) { return pow(2 - R, 3) * (R / 2 + 1); },
                    {5.0 / 48, 15 / (64 * pi), 21 / (128 * pi)}};
  rows["schuessler_schmitt"] = {[](double R) { return std::sqrt(2.0) - std::sqrt(R); },
                                {3 / (4 * s2), 5 / (4 * s2 * pi), 21 / (32 * s2 * pi)}};
  rows["johnson_beissel"] = {[](double R) { return R * R / 4 - R + 1; },
                             {3.0 / 4, 3 / (2 * pi), 15 / (16 * pi)}};
  rows["core_triangle"] = {[alpha](double R) {
                             const double x = R / 2;
                             if (x < alpha)
                               return (-12 * alpha + 18 * alpha * alpha) * x + 1 +
                                      6 * alpha * alpha - 12 * alpha * alpha * alpha;
                             return x < 0.5 ? 1 - 6 * x * x + 6 * x * x * x : 2 * pow(1 - x, 3);
                           },
                           {54.0 / 85, 162 / (115 * pi), 3645 / (3661 * pi)}};
  return rows;
}

TYPED_TEST(KernelTest, IsWhatTheSourcesPrint) {
  const auto rows = printedRows();
  ASSERT_TRUE(rows.contains(TypeParam::name));
  const Row& row = rows.at(TypeParam::name);
  for (std::size_t d = 0; d < 3; ++d) {
    // The same fraction, typed twice: at most an order of multiplications differs.
    EXPECT_NEAR(TypeParam::sigma[d], row.sigma[d], 2e-16 * row.sigma[d]) << d + 1;
  }
  for (double R = 0; R <= 2; R += 0.01) {
    // Other groupings of the same polynomial: some units of rounding of its largest term, f(0) for
    // most, 5 for the sums of Liu.
    EXPECT_NEAR(TypeParam::f(R), row.f(R), 4e-15 * std::max(1.0, row.f(0))) << R;
  }
}

TYPED_TEST(KernelTest, ChosenAtRunTimeGivesTheSameBits) {
  const KernelId id = KernelId::named(std::string(TypeParam::name));
  EXPECT_EQ(id.index(), kernel::indexOf<TypeParam>());
  const kernel::Any any{id};
  for (double R = 0; R < 2.1; R += 0.003) {
    EXPECT_EQ(any.f(R), TypeParam::f(R));
    EXPECT_EQ(any.g(R), TypeParam::g(R));
  }
  for (int dim = 1; dim <= 3; ++dim)
    EXPECT_EQ(any.sigma(dim), TypeParam::sigma[static_cast<std::size_t>(dim - 1)]);
}

TEST(KernelId, KnowsEveryRowAndNoOther) {
  const auto rows = printedRows();
  EXPECT_EQ(KernelId::names().size(), rows.size());
  for (const std::string& name : KernelId::names()) {
    EXPECT_TRUE(rows.contains(name)) << name;
    EXPECT_EQ(KernelId::named(name).name(), name);
  }
  EXPECT_THROW(KernelId::named("gaussian"), InputError);
}

}  // namespace
}  // namespace plenum
