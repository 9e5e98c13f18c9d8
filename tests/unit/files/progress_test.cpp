// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace plenum {
namespace {

struct Stage {
  std::ostringstream out;
  double clock = 0;
  Progress::Output output(Progress::Style style) {
    return {style, &out, [this] { return clock; }};
  }
};

TEST(Progress, LogGetsALineForEveryTenth) {
  Stage stage;
  Progress progress("relax", 1000, stage.output(Progress::Style::log));
  for (int k = 1; k <= 1000; ++k) {
    stage.clock += 0.001;
    progress.update(k);
  }
  progress.finish();
  const std::string text = stage.out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);  // ten tenths and the end
  EXPECT_NE(text.find("relax: 50 %, 0.5 s left\n"), std::string::npos) << text;
  EXPECT_NE(text.find("relax: done in 1.0 s\n"), std::string::npos) << text;
  EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST(Progress, SlowWorkSaysSomethingEveryTenSeconds) {
  Stage stage;
  Progress progress("run", 1e6, stage.output(Progress::Style::log));
  for (int k = 1; k <= 100; ++k) {
    stage.clock += 1;
    progress.update(k, "step " + std::to_string(k));
  }
  const std::string text = stage.out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_NE(text.find("step 20"), std::string::npos) << text;
}

TEST(Progress, TerminalIsRedrawnAtMostTenTimesASecond) {
  Stage stage;
  {
    Progress progress("run", 10000, stage.output(Progress::Style::terminal));
    for (int k = 1; k <= 10000; ++k) {
      stage.clock += 1e-4;  // one second in all
      progress.update(k);
    }
  }
  const std::string text = stage.out.str();
  EXPECT_LE(std::count(text.begin(), text.end(), '\r'), 10);
  EXPECT_GE(std::count(text.begin(), text.end(), '\r'), 8);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);  // the destructor ends the line
}

TEST(Progress, QuietSaysNothing) {
  Stage stage;
  Progress progress("run", 10, stage.output(Progress::Style::quiet));
  progress.update(5);
  progress.finish();
  EXPECT_EQ(stage.out.str(), "");
}

TEST(Progress, NoWorkAtAll) {
  Stage stage;
  Progress progress("run", 0, stage.output(Progress::Style::log));
  stage.clock = 20;
  progress.update(0);
  progress.finish();
  EXPECT_NE(stage.out.str().find("run: 0 %"), std::string::npos) << stage.out.str();
}

TEST(Progress, Durations) {
  EXPECT_EQ(printedDuration(0.04), "0.0 s");
  EXPECT_EQ(printedDuration(9.94), "9.9 s");
  EXPECT_EQ(printedDuration(42.4), "42 s");
  EXPECT_EQ(printedDuration(185), "3 min 05 s");
  EXPECT_EQ(printedDuration(7800), "2 h 10 min");
  EXPECT_EQ(printedDuration(5 * 86400 + 3 * 3600), "5 d 03 h");
  EXPECT_EQ(printedDuration(1e300), "ages");
}

}  // namespace
}  // namespace plenum
