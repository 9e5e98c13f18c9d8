// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/key.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace plenum::study {
namespace {

std::string keyOf(const std::vector<std::string>& texts) {
  Key key;
  for (const std::string& text : texts) key.add(text);
  return key.text();
}

TEST(Key, DependsOnEachTextAndItsPlace) {
  EXPECT_EQ(keyOf({"a", "b"}), keyOf({"a", "b"}));
  EXPECT_NE(keyOf({"a", "b"}), keyOf({"b", "a"}));
  EXPECT_NE(keyOf({"ab", "c"}), keyOf({"a", "bc"}));
  EXPECT_NE(keyOf({}), keyOf({""}));
  EXPECT_EQ(keyOf({}).size(), 16u);
}

TEST(Key, DependsOnTheBytesOfFiles) {
  const test::TemporaryFolder folder;
  const auto keyOfFile = [&](const std::string& text) {
    writeTextFile(folder / "file", text);
    Key key;
    key.addFile(folder / "file");
    return key.text();
  };
  const std::string longText(200'000, 'x');  // several parts of a read
  EXPECT_EQ(keyOfFile(longText), keyOfFile(longText));
  EXPECT_NE(keyOfFile(longText), keyOfFile(longText + "x"));
  Key key;
  EXPECT_THROW(key.addFile(folder / "missing"), InputError);
}

}  // namespace
}  // namespace plenum::study
