// SPDX-License-Identifier: GPL-3.0-or-later
//
// The choice is made once a program, so that each of these asks in a program of its own.
#include "engine/instruction_set.hpp"

#include "particles/errors.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <iostream>
#include <string>
#include <type_traits>

namespace plenum {
namespace {

constexpr InstructionSet allSets[] = {InstructionSet::baseline, InstructionSet::avx2,
                                      InstructionSet::avx512};
constexpr const char* words[] = {"baseline", "avx2", "avx512"};

/// Ends the process: prints the set that is chosen, or the error.
[[noreturn]] void printChoice(const char* asked) {
  if (asked == nullptr)
    unsetenv("PLENUM_INSTRUCTION_SET");
  else
    setenv("PLENUM_INSTRUCTION_SET", asked, 1);
  try {
    std::cerr << "chosen: " << nameOf(instructionSet()) << "\n";
    exit(0);
  } catch (const InputError& error) {
    std::cerr << "refused: " << error.what() << "\n";
    exit(1);
  }
}

class InstructionSetDeathTest : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(InstructionSetDeathTest, TheBestIsChosenIfNothingIsAsked) {
  std::string best;
  for (const InstructionSet set : allSets)
    if (isAvailable(set)) best = nameOf(set);
  for (char& c : best)
    if (c == '+') c = '.';  // the expectation is a regular expression
  EXPECT_EXIT(printChoice(nullptr), testing::ExitedWithCode(0), "chosen: " + best);
  EXPECT_EXIT(printChoice(""), testing::ExitedWithCode(0), "chosen: " + best);
}

TEST_F(InstructionSetDeathTest, WhatIsAskedIsChosenOrRefused) {
  for (const int k : {0, 1, 2}) {
    if (isAvailable(allSets[k])) {
      std::string name(nameOf(allSets[k]));
      for (char& c : name)
        if (c == '+') c = '.';
      EXPECT_EXIT(printChoice(words[k]), testing::ExitedWithCode(0), "chosen: " + name);
    } else {
      EXPECT_EXIT(printChoice(words[k]), testing::ExitedWithCode(1),
                  std::string("refused: .*") + words[k]);
    }
  }
}

TEST_F(InstructionSetDeathTest, AnUnknownNameIsRefused) {
  EXPECT_EXIT(printChoice("sse9"), testing::ExitedWithCode(1),
              "refused: .*sse9.*baseline, avx2 or avx512");
}

TEST(InstructionSet, TheBaselineIsAlwaysThere) {
  EXPECT_TRUE(isAvailable(InstructionSet::baseline));
  EXPECT_EQ(nameOf(InstructionSet::baseline), isa::Baseline::name);
}

#if defined(PLENUM_HAS_X86_LOOPS)
TEST(InstructionSet, EachHasItsTypeAndName) {
  EXPECT_EQ(nameOf(InstructionSet::avx2), isa::Avx2::name);
  EXPECT_EQ(nameOf(InstructionSet::avx512), isa::Avx512::name);
  EXPECT_TRUE(withInstructionSet(
      InstructionSet::avx512, [](auto isa) { return std::is_same_v<decltype(isa), isa::Avx512>; }));
  EXPECT_TRUE(withInstructionSet(
      InstructionSet::avx2, [](auto isa) { return std::is_same_v<decltype(isa), isa::Avx2>; }));
}
#endif

}  // namespace
}  // namespace plenum
