// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/csv_points.hpp"

#include "particles/errors.hpp"

#include <gtest/gtest.h>

namespace plenum {
namespace {

std::string messageOf(const std::string& text, int dimension) {
  try {
    readCsvPoints(text, dimension, "a.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CsvPoints, FindsColumnsByName) {
  for (const std::string head :
       {"id,z,y,x", "id, position_z [m], position_y [m], position_x [m]",
        "\"id\",\"Points:2\",\"Points:1\",\"Points:0\"", "ID,Points_2,Points_1,Points_0"}) {
    const FilePoints read = readCsvPoints(head + "\n7,3,2,1\n8,6,5,4\r\n\n", 3, "a.csv");
    ASSERT_EQ(read.positions.size(), 2u) << head;
    EXPECT_EQ(read.positions[0], (Vec<3>{{1, 2, 3}})) << head;
    EXPECT_EQ(read.positions[1], (Vec<3>{{4, 5, 6}})) << head;
  }
}

TEST(CsvPoints, NumbersAloneAreCoordinates) {
  for (const std::string text : {"1,2,9\n-.5,+4,9", "1;2;9\n-.5;4;9", "1\t2\t9\n-0.5\t4\t9\n",
                                 "# x y\n  1   2 9  \n -5e-1 4 9\n"}) {
    const FilePoints read = readCsvPoints(text, 2, "a.csv");
    ASSERT_EQ(read.positions.size(), 2u) << text;
    EXPECT_EQ(read.positions[0], (Vec<3>{{1, 2, 0}})) << text;
    EXPECT_EQ(read.positions[1], (Vec<3>{{-0.5, 4, 0}})) << text;
  }
}

TEST(CsvPoints, LeavesWallsOut) {
  const FilePoints read = readCsvPoints("x,type\n1,0\n2,1\n3,0\n", 1, "a.csv");
  EXPECT_EQ(read.nWalls, 1u);
  ASSERT_EQ(read.positions.size(), 2u);
  EXPECT_EQ(read.positions[1][0], 3);
  EXPECT_EQ(readCsvPoints("x,type\n1,0\n2,1\n3,2\n", 1, "a.csv").positions.size(), 3u);
}

TEST(CsvPoints, ErrorsNameTheLine) {
  EXPECT_TRUE(messageOf("x,z\n1,2\n", 2).starts_with("a.csv:1: no column is named y"));
  EXPECT_TRUE(messageOf("x,y\n1,2\n\n3\n", 2).starts_with("a.csv:4: has 1 columns, needs 2"));
  EXPECT_TRUE(messageOf("x,y\n1,two\n", 2).starts_with("a.csv:2: 'two' is not a number"));
  EXPECT_TRUE(messageOf("x,y\n1,nan\n", 2).starts_with("a.csv:2: 'nan' is not a finite"));
  EXPECT_TRUE(readCsvPoints("", 2, "a.csv").positions.empty());
}

}  // namespace
}  // namespace plenum
