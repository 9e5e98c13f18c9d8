// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/motion_table.hpp"

#include "particles/errors.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace plenum {
namespace {

std::string messageOf(const std::string& text, int dimension) {
  try {
    readMotionTable(text, dimension, "a.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MotionTableFile, FindsColumnsByName) {
  for (const std::string text :
       {"time,x,y\n0,1,2\n.5,3,-4\n", "Y [m]; \"time [s]\"; X\n2;0;1\n-4;0.5;3\r\n\n",
        "# recorded\n time  x  y\n 0 1 2\n# more\n 5e-1  3 -4",
        "time\ty\tx\n0\t2\t1\n0.5\t-4\t3"}) {
    const MotionTableFile file = readMotionTable(text, 2, "a.csv");
    EXPECT_EQ(file.table.times, (std::vector<double>{0, 0.5})) << text;
    ASSERT_EQ(file.table.places.size(), 2u) << text;
    EXPECT_EQ(file.table.places[0], (std::array<double, 4>{1, 2, 0, 0})) << text;
    EXPECT_EQ(file.table.places[1], (std::array<double, 4>{3, -4, 0, 0})) << text;
    EXPECT_FALSE(file.hasAngle);
  }
}

TEST(MotionTableFile, AnglesAreInDegrees) {
  const MotionTableFile file = readMotionTable("time,angle [degrees]\n-1,90\n2,-45", 3, "a.csv");
  EXPECT_TRUE(file.hasAngle);
  EXPECT_DOUBLE_EQ(file.table.places[0][3], std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(file.table.places[1][3], -std::numbers::pi / 4);
}

TEST(MotionTableFile, SaysWhatIsWrongAndWhere) {
  const auto expectSays = [](const std::string& text, int dimension, const std::string& says) {
    const std::string message = messageOf(text, dimension);
    EXPECT_NE(message.find(says), std::string::npos) << text << "\nsays: " << message;
  };
  expectSays("time,x\n0,1\n1,b\n", 2, "a.csv:3: ");
  expectSays("time,x\n0,1\n1,nan\n", 2, "a.csv:3: ");
  expectSays("time,x\n0,1\n1\n", 2, "a.csv:3: has 1 columns, needs 2");
  expectSays("time,x\n0,1\n1,2\n1,3\n", 2, "a.csv:4: time = 1 s is not after 1 s");
  expectSays("time,x\n0,1\n-1,2\n", 2, "a.csv:3: time = -1 s is not after 0 s");
  expectSays("time,x\n0,1\n", 2, "has 1 row of numbers, needs two or more");
  expectSays("# nothing\n", 2, "has 0 rows of numbers, needs two or more");
  expectSays("time,w\n0,1\n1,1\n", 2,
             "a.csv:1: unknown column \"w\"; the first line names the "
             "columns, in 2 dimensions of: time, x, y, angle");
  expectSays("time,z\n0,1\n1,1\n", 2, "unknown column \"z\"");
  expectSays("time,angle\n0,1\n1,1\n", 1, "unknown column \"angle\"");
  expectSays("0,1\n1,1\n", 2, "unknown column \"0\"");
  expectSays("x,y\n0,1\n1,1\n", 2, "no column is named time");
  expectSays("time\n0\n1\n", 2, "has the column time only");
  expectSays("time,x,x\n0,1,2\n1,1,2\n", 2, "two columns \"x\"");
  expectSays("time,angle [rad]\n0,1\n1,1\n", 2, "column \"angle\" is in rad, must be in degrees");
  expectSays("time [ms],x\n0,1\n1,1\n", 2, "column \"time\" is in ms, must be in s");
  expectSays("time,x [mm]\n0,1\n1,1\n", 2, "column \"x\" is in mm, must be in m");
}

}  // namespace
}  // namespace plenum
