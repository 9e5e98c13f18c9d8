// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/findings.hpp"
#include "particles/case_node.hpp"
#include "particles/memory.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

TEST(Findings, TheRemedyOfAMessageStandsBehindItsLastSemicolon) {
  const Finding finding = findingOf(Severity::warning, "a.toml: x; y; do z");
  EXPECT_EQ(finding.what, "a.toml: x; y");
  EXPECT_EQ(finding.remedy, "do z");
  EXPECT_EQ(finding.text(), "a.toml: x; y; do z");
  EXPECT_EQ(findingOf(Severity::note, "all is well").text(), "all is well");
}

TEST(Findings, ErrorsAreCollectedAndThrownTogether) {
  Findings findings;
  findings.throwErrors();
  EXPECT_TRUE(findings.attempt([] {}));
  findings.warner()("thin; make it thicker");
  findings.throwErrors();  // warnings are no errors
  EXPECT_FALSE(findings.attempt([] { throw InputError("first; mend it"); }));
  EXPECT_FALSE(findings.attempt([] {
    throw FaultyInput({{Severity::error, "second", "a", {1}}, {Severity::error, "third", "b", {}}});
  }));
  EXPECT_FALSE(findings.attempt([] { throw FollowingError("follows; mend the first"); }));
  EXPECT_EQ(findings.count(Severity::error), 3u);
  EXPECT_EQ(findings.all().size(), 4u);
  try {
    findings.throwErrors();
    FAIL();
  } catch (const FaultyInput& error) {
    EXPECT_EQ(error.errors().size(), 3u);
    EXPECT_STREQ(error.what(), "first; mend it (and 2 more errors: plenum-ic check lists all)");
  }
  EXPECT_THROW(findings.attempt([] { throw RunError("disk"); }),
               RunError);  // no fault of the input
}

TEST(Findings, NodesSayWhereEachStands) {
  const CaseNode root = CaseNode::parse("\npart = 1\n", "a.toml");
  try {
    root.find("part")->fail(FaultyInput(
        {{Severity::error, "open", "close", {1, 2}}, {Severity::error, "flat", "remove", {}}}));
    FAIL();
  } catch (const FaultyInput& error) {
    EXPECT_EQ(error.errors()[1].what, "a.toml:2: part = 1: flat");
    EXPECT_EQ(error.errors()[0].place, (std::vector<double>{1, 2}));
  }
  EXPECT_THROW(root.find("part")->fail(FollowingError("x")), FollowingError);
}

TEST(Memory, TheMachineSaysWhatItHas) {
  const auto available = availableMemory();
  ASSERT_TRUE(available);
  EXPECT_GT(*available, 1e6);   // or this test would not run
  EXPECT_LT(*available, 1e15);  // kilobytes taken for bytes, or the other way round, would show
  EXPECT_EQ(printedBytes(3.21e9), "3.21 GB");
  EXPECT_EQ(printedBytes(800), "800 bytes");
}

}  // namespace
}  // namespace plenum
