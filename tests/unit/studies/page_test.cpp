// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/page.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plenum::study {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Page, EscapesTexts) {
  const std::string html =
      htmlOf(Page{"a < b & c", {{"head", {"if x > \"1\""}, {}, {{"<col>"}, {{"<cell>"}}}, {}}}});
  EXPECT_THAT(html, HasSubstr("<h1>a &lt; b &amp; c</h1>"));
  EXPECT_THAT(html, HasSubstr("if x &gt; &quot;1&quot;"));
  EXPECT_THAT(html, HasSubstr("&lt;cell&gt;"));
  EXPECT_THAT(html, Not(HasSubstr("<cell>")));
}

/// Also what its style and script name: a browser without a network shows all of it.
TEST(Page, NeedsNothingElse) {
  const test::TemporaryFolder folder;
  writeTextFile(folder / "p.png", "foobar");
  const std::string html = htmlOf(Page{"t", {{"h", {}, {}, {}, {{folder / "p.png", "caption"}}}}});
  EXPECT_THAT(html, HasSubstr("src=\"data:image/png;base64,Zm9vYmFy\""));
  EXPECT_THAT(html, Not(HasSubstr("http")));
}

/// The vectors of RFC 4648.
TEST(Page, StoresPicturesOfAnyLength) {
  const test::TemporaryFolder folder;
  for (const auto& [bytes, text] : {std::pair{"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}}) {
    writeTextFile(folder / "p.png", bytes);
    EXPECT_THAT(htmlOf(Page{"t", {{"h", {}, {}, {}, {{folder / "p.png", "c"}}}}}),
                HasSubstr(std::string("base64,") + text + "\""));
  }
  EXPECT_THROW(htmlOf(Page{"t", {{"h", {}, {}, {}, {{folder / "none.png", "c"}}}}}), RunError);
}

TEST(Page, KnowsColumnsOfNumbers) {
  const std::string html =
      htmlOf(Page{"t", {{"h", {}, {}, {{"name", "n"}, {{"a", "1e-3"}, {"b", ""}}}, {}}}});
  EXPECT_THAT(html, HasSubstr("<th class=\"text\">name</th><th>n</th>"));
}

TEST(Page, LeavesEmptyPartsOut) {
  EXPECT_THAT(htmlOf(Page{"t", {{"nothing here", {}, {}, {}, {}}}}), Not(HasSubstr("nothing")));
}

}  // namespace
}  // namespace plenum::study
