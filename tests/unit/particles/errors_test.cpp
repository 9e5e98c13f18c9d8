// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/errors.hpp"

#include <gtest/gtest.h>

#include <new>
#include <string>
#include <vector>

namespace plenum {
namespace {

TEST(Errors, EditDistance) {
  EXPECT_EQ(editDistance("", ""), 0);
  EXPECT_EQ(editDistance("kernel", "kernel"), 0);
  EXPECT_EQ(editDistance("kernle", "kernel"), 2);
  EXPECT_EQ(editDistance("spacing", "spaceing"), 1);
  EXPECT_EQ(editDistance("", "abc"), 3);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3);
}

TEST(Errors, NearestOfKnownWords) {
  const std::vector<std::string> known{"kernel", "smoothing_length", "sound_speed"};
  EXPECT_EQ(nearest("kernal", known), "kernel");
  EXPECT_EQ(nearest("soundspeed", known), "sound_speed");
  EXPECT_EQ(nearest("xyz", known), "") << "nothing is near";
  EXPECT_EQ(nearest("kernel", std::vector<std::string>{}), "");
}

template <class Body>
std::pair<int, std::string> codeAndMessage(Body body) {
  testing::internal::CaptureStderr();
  const int code = runProgram("plenum-test", body);
  return {code, testing::internal::GetCapturedStderr()};
}

TEST(Errors, ExitCodesAndMessages) {
  using Result = std::pair<int, std::string>;
  EXPECT_EQ(codeAndMessage([] { return 0; }), Result(0, ""));
  EXPECT_EQ(codeAndMessage([]() -> int { throw InputError("case.toml:3: wrong"); }),
            Result(1, "plenum-test: case.toml:3: wrong\n"));
  EXPECT_EQ(codeAndMessage([]() -> int { throw RunError("not finite"); }),
            Result(2, "plenum-test: not finite\n"));
  EXPECT_EQ(codeAndMessage([]() -> int { throw std::bad_alloc(); }).first, 2);
  EXPECT_EQ(codeAndMessage([]() -> int { throw 42; }).first, 2);
}

}  // namespace
}  // namespace plenum
