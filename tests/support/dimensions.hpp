// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <type_traits>

namespace plenum::test {

/// For TYPED_TEST_SUITE: the body takes its dimension from TypeParam::value.
using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;

}  // namespace plenum::test
