// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every operation of a pack against the same one on single numbers, for all lengths and all
// instruction sets of this processor.
#include "engine/pack.hpp"

#include "engine/instruction_set.hpp"
#include "tests/unit/engine/pack_operations.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

namespace plenum {
namespace {

using test::PackOperation;

/// Calls test(lanes, apply) for each length of pack on each instruction set.
template <class T, class Test>
void forEachPack(Test&& test) {
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!isAvailable(set)) continue;
    withInstructionSet(set, [&](auto isa) {
      SCOPED_TRACE(nameOf(set));
      using Isa = decltype(isa);
      test(2, &test::apply<Isa, T, 2>);
      test(4, &test::apply<Isa, T, 4>);
      test(8, &test::apply<Isa, T, 8>);
    });
  }
}

template <class T>
using Lanes = std::array<T, 8>;

/// Lanes of any sign, of sizes over many powers of ten.
template <class T>
std::vector<Lanes<T>> manyLanes(unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<T> exponent(-6, 6), sign(-1, 1);
  std::vector<Lanes<T>> many(2000);
  for (Lanes<T>& lanes : many)
    for (T& x : lanes) x = std::copysign(std::pow(T(10), exponent(generator)), sign(generator));
  return many;
}

/// What one lane of a result should be.
template <class T>
T expected(PackOperation operation, T a, T b) {
  switch (operation) {
    case PackOperation::add:
    case PackOperation::addTo:
      return a + b;
    case PackOperation::subtract:
    case PackOperation::subtractFrom:
      return a - b;
    case PackOperation::multiply:
    case PackOperation::multiplyBy:
      return a * b;
    case PackOperation::negate:
      return -a;
    case PackOperation::larger:
      return std::max(a, b);
    case PackOperation::smaller:
    case PackOperation::chooseSmaller:
      return std::min(a, b);
    case PackOperation::positive:
      return std::max(a, T(0));
    case PackOperation::negative:
      return std::min(a, T(0));
    default:
      return std::numeric_limits<T>::quiet_NaN();
  }
}

template <class T>
class PackTest : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(PackTest, Numbers);

TYPED_TEST(PackTest, OneRoundingIsTheSameAsThatOfSingleNumbers) {
  using T = TypeParam;
  const auto as = manyLanes<T>(1), bs = manyLanes<T>(2);
  forEachPack<T>([&](int n, auto apply) {
    for (const PackOperation operation :
         {PackOperation::add, PackOperation::subtract, PackOperation::multiply,
          PackOperation::addTo, PackOperation::subtractFrom, PackOperation::multiplyBy,
          PackOperation::negate, PackOperation::larger, PackOperation::smaller,
          PackOperation::chooseSmaller, PackOperation::positive, PackOperation::negative})
      for (std::size_t k = 0; k < as.size(); ++k) {
        Lanes<T> out{};
        apply(operation, as[k].data(), bs[k].data(), out.data());
        for (std::size_t lane = 0; lane < static_cast<std::size_t>(n); ++lane)
          ASSERT_EQ(out[lane], expected(operation, as[k][lane], bs[k][lane]))
              << "operation " << static_cast<int>(operation) << ", " << n << " lanes";
      }
  });
}

TYPED_TEST(PackTest, DividesAndTakesRootsAccurately) {
  using T = TypeParam;
  // Estimates of 11.4 bits and a Newton step leave 1.5 2^-22.8 = 2e-7 and some roundings; numbers
  // in double are divided by the processor: 1/b and its product with a round once each.
  const double tolerance = std::is_same_v<T, float> ? 4e-7 : 2.3e-16;
  const auto as = manyLanes<T>(3), bs = manyLanes<T>(4);
  forEachPack<T>([&](int n, auto apply) {
    double worstQuotient = 0, worstRoot = 0;
    for (std::size_t k = 0; k < as.size(); ++k) {
      Lanes<T> positive, quotient{}, root{};
      for (std::size_t lane = 0; lane < 8; ++lane) positive[lane] = std::abs(as[k][lane]);
      apply(PackOperation::divide, as[k].data(), bs[k].data(), quotient.data());
      apply(PackOperation::root, positive.data(), bs[k].data(), root.data());
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(n); ++lane) {
        const long double a = as[k][lane], b = bs[k][lane], s = std::sqrt(std::abs(a));
        worstQuotient = std::max(worstQuotient,
                                 static_cast<double>(std::abs((quotient[lane] - a / b) / (a / b))));
        worstRoot = std::max(worstRoot, static_cast<double>(std::abs((root[lane] - s) / s)));
      }
    }
    std::cout << "  " << (sizeof(T) == 4 ? "float" : "double") << " x " << n
              << ": largest relative error of a/b " << worstQuotient << ", of the root "
              << worstRoot << "\n";
    EXPECT_LE(worstQuotient, tolerance);
    EXPECT_LE(worstRoot, tolerance);
  });
}

TYPED_TEST(PackTest, TheRootOfZeroIsZero) {
  using T = TypeParam;
  forEachPack<T>([&](int n, auto apply) {
    const Lanes<T> zeros{};
    Lanes<T> out;
    out.fill(1);
    apply(PackOperation::root, zeros.data(), zeros.data(), out.data());
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(n); ++lane) EXPECT_EQ(out[lane], 0);
  });
}

TYPED_TEST(PackTest, RaisesToPowersAndFills) {
  using T = TypeParam;
  const auto as = manyLanes<T>(5);
  forEachPack<T>([&](int n, auto apply) {
    for (const Lanes<T>& a : as) {
      Lanes<T> fifth{}, filled{};
      apply(PackOperation::fifthPower, a.data(), a.data(), fifth.data());
      apply(PackOperation::fill, a.data(), a.data(), filled.data());
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(n); ++lane) {
        const T exact = static_cast<T>(std::pow(static_cast<long double>(a[lane]), 5));
        // Three products, one of them squared: 2 + 1 + 1 roundings of half an ulp.
        EXPECT_NEAR(fifth[lane], exact, 2 * std::numeric_limits<T>::epsilon() * std::abs(exact));
        EXPECT_EQ(filled[lane], a[0]);
      }
    }
  });
}

TYPED_TEST(PackTest, AddsUpLanesInOneOrder) {
  using T = TypeParam;
  const auto as = manyLanes<T>(6);
  forEachPack<T>([&](int n, auto apply) {
    for (const Lanes<T>& a : as) {
      Lanes<T> out{}, partial = a;
      apply(PackOperation::sum, a.data(), a.data(), out.data());
      // The upper half on the lower one, again and again.
      for (std::size_t half = static_cast<std::size_t>(n) / 2; half > 0; half /= 2)
        for (std::size_t k = 0; k < half; ++k) partial[k] += partial[k + half];
      EXPECT_EQ(out[0], partial[0]) << n << " lanes";
    }
  });
}

TYPED_TEST(PackTest, FindsTheLanesBelowALimit) {
  using T = TypeParam;
  std::mt19937_64 generator(7);
  std::uniform_int_distribution<int> few(1, 3);
  forEachPack<T>([&](int n, auto apply) {
    for (int trial = 0; trial < 1000; ++trial) {
      Lanes<T> a, limit, out{};
      limit.fill(2);
      unsigned bits = 0;
      for (std::size_t lane = 0; lane < 8; ++lane) {
        a[lane] = static_cast<T>(few(generator));  // equal is not below
        if (a[lane] < 2 && lane < static_cast<std::size_t>(n)) bits |= 1u << lane;
      }
      apply(PackOperation::below, a.data(), limit.data(), out.data());
      EXPECT_EQ(static_cast<unsigned>(out[0]), bits) << n << " lanes";
    }
  });
}

TYPED_TEST(PackTest, NaNSurvivesArithmeticInItsLane) {
  using T = TypeParam;
  forEachPack<T>([&](int n, auto apply) {
    for (const PackOperation operation :
         {PackOperation::add, PackOperation::subtract, PackOperation::multiply,
          PackOperation::divide, PackOperation::addTo, PackOperation::subtractFrom,
          PackOperation::multiplyBy, PackOperation::negate})
      for (std::size_t place = 0; place < static_cast<std::size_t>(n); ++place)
        for (const bool inFirst : {true, false}) {
          Lanes<T> a, b, out{};
          a.fill(3);
          b.fill(2);
          if (!inFirst && operation == PackOperation::negate) continue;
          (inFirst ? a : b)[place] = std::numeric_limits<T>::quiet_NaN();
          apply(operation, a.data(), b.data(), out.data());
          for (std::size_t lane = 0; lane < static_cast<std::size_t>(n); ++lane)
            EXPECT_EQ(std::isnan(out[lane]), lane == place)
                << "operation " << static_cast<int>(operation);
        }
  });
}

}  // namespace
}  // namespace plenum
