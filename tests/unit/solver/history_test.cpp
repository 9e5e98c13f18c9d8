// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/history.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <sstream>

namespace plenum {
namespace {

TEST(History, UnitsInTheHeaderAndEmptyCells) {
  const test::TemporaryFolder folder;
  History history(folder / "history.csv");
  const double none = std::numeric_limits<double>::quiet_NaN();
  history.add({{"p1", "Pa", none}, {"time", "s", 0.5}, {"left", "", none}});
  history.add({{"p1", "Pa", 2}, {"time", "s", 1}, {"left", "", 3}});
  std::ostringstream text;
  text << std::ifstream(folder / "history.csv").rdbuf();
  EXPECT_EQ(text.str(), "p1 [Pa],time [s],left\n,0.5,\n2,1,3\n");
}

}  // namespace
}  // namespace plenum
