// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/lists.hpp"

#include "particles/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum::study {
namespace {

TEST(Lists, AreRead) {
  std::vector<double> numbers{7};
  readList("--alpha", "-1,2.5,3e-2", numbers);
  EXPECT_EQ(numbers, (std::vector<double>{-1, 2.5, 3e-2}));
  std::vector<std::string> words;
  readList("--scenes", "box,tank", words);
  EXPECT_EQ(words, (std::vector<std::string>{"box", "tank"}));
  for (const char* text : {"", ",", "1,", "1,,2", "x", "1x", "1e999"})
    EXPECT_THROW(readList("--alpha", text, numbers), InputError) << text;
}

TEST(Lists, AreHeldToTheirRange) {
  EXPECT_NO_THROW(requireNumbers("--alpha", {0, 0.5, 1}, 0, 1));
  for (const std::vector<double>& values :
       {std::vector<double>{}, {-0.1}, {1.1}, {std::nan("")}, {0.5, 0.5}})
    EXPECT_THROW(requireNumbers("--alpha", values, 0, 1), InputError);
  EXPECT_NO_THROW(requireWords("--scenes", {"box"}, {"box", "tank"}));
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{}, {"bok"}, {"box", "box"}})
    EXPECT_THROW(requireWords("--scenes", words, {"box", "tank"}), InputError);
}

}  // namespace
}  // namespace plenum::study
