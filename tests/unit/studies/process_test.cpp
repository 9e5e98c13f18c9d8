// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/process.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <numeric>
#include <stdexcept>

namespace plenum::study {
namespace {

ProcessEnd shell(const std::string& script) { return runProcess({"/bin/sh", "-c", script}); }

TEST(Process, SaysHowItsProgramEnded) {
  EXPECT_TRUE(shell("exit 0").isDone());
  EXPECT_EQ(shell("exit 3").exitCode, 3);
  const ProcessEnd killed = shell("kill -TERM $$");
  EXPECT_EQ(killed.signal, SIGTERM);
  EXPECT_FALSE(killed.isDone());
  EXPECT_EQ(runProcess({"/no/such/program"}).exitCode, 127);
}

/// More than a pipe holds.
TEST(Process, ReadsAllThatGoesToStderr) {
  const ProcessEnd end = shell(
      "i=0; while [ $i -lt 3000 ]; do echo 'thirty letters, more or less' "
      ">&2; echo no; i=$((i + 1)); done");
  EXPECT_EQ(end.errors.size(), 3000 * std::string("thirty letters, more or less\n").size());
}

/// Of work that takes about as long as it computes: not less CPU time than a tenth of it, however
/// busy the machine is, and not more than all of it.
TEST(Process, CountsWhatItsProgramTook) {
  const ProcessEnd end = shell("i=0; while [ $i -lt 200000 ]; do i=$((i + 1)); done");
  EXPECT_GT(end.cpuSeconds, 0.01);
  EXPECT_LE(end.cpuSeconds, 1.1 * end.wallSeconds + 0.02);  // clocks tick in hundredths
  EXPECT_GT(end.peakBytes, 1e5);
  EXPECT_LT(shell("sleep 0.3").cpuSeconds, 0.2);
}

TEST(InParallel, CallsEachOnce) {
  for (const int jobs : {1, 3, 50}) {
    std::vector<std::atomic<int>> calls(20);
    inParallel(calls.size(), jobs, [&](std::size_t k) { ++calls[k]; });
    for (const auto& n : calls) EXPECT_EQ(n, 1);
  }
}

TEST(InParallel, ThrowsOnAndStops) {
  std::atomic<int> calls = 0;
  EXPECT_THROW(inParallel(1000, 2,
                          [&](std::size_t) {
                            ++calls;
                            throw std::runtime_error("no");
                          }),
               std::runtime_error);
  EXPECT_LE(calls, 2);
}

}  // namespace
}  // namespace plenum::study
