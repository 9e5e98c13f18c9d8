// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/numbers.hpp"

#include <gtest/gtest.h>

namespace plenum::study {
namespace {

TEST(Numbers, AreReadWhole) {
  EXPECT_EQ(numberIn("2"), 2);
  EXPECT_EQ(numberIn(".05"), 0.05);
  EXPECT_EQ(numberIn("1e-3"), 1e-3);
  for (const char* text : {"", " 2", "2 ", "2x", "two"}) EXPECT_FALSE(numberIn(text)) << text;
}

TEST(Numbers, AreRoundedDownTo125) {
  EXPECT_DOUBLE_EQ(roundedDown(0.99), 0.5);
  EXPECT_DOUBLE_EQ(roundedDown(1), 1);
  EXPECT_DOUBLE_EQ(roundedDown(4.9), 2);
  EXPECT_DOUBLE_EQ(roundedDown(0.023), 0.02);
  EXPECT_DOUBLE_EQ(roundedDown(7000), 5000);
}

}  // namespace
}  // namespace plenum::study
