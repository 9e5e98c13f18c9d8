// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/vtu_reader.hpp"

#include "particles/errors.hpp"
#include "particles/vtu_writer.hpp"

#include "sample_scene.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace plenum {
namespace {

std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

std::string messageOf(const std::string& bytes) {
  try {
    readVtuPoints(bytes, "sample.vtu");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A file of two points, with this DataArray and these attributes of VTKFile.
std::string fileWith(const std::string& array, const std::string& attributes = "") {
  return "<VTKFile type=\"UnstructuredGrid\" " + attributes +
         "><UnstructuredGrid><Piece NumberOfPoints=\"2\"><Points>" + array +
         "</Points></Piece></UnstructuredGrid></VTKFile>";
}

template <int Dim>
void expectRoundTrip(std::size_t nFluid, std::size_t nWalls) {
  const TemporaryFolder folder;
  const Scene<Dim> scene = sampleScene<Dim>(-1, 1, nFluid, nWalls);
  writeVtu(folder.path() / "sample.vtu", scene.particles);
  const FilePoints read = readVtuPoints(bytesOf(folder.path() / "sample.vtu"), "sample.vtu");
  EXPECT_EQ(read.nWalls, nWalls);
  ASSERT_EQ(read.positions.size(), nFluid);
  for (std::size_t k = 0; k < nFluid; ++k)
    for (int a = 0; a < 3; ++a)
      ASSERT_EQ(read.positions[k][a], a < Dim ? scene.particles[field::position][k][a] : 0);
}

TEST(VtuReader, ReadsTheFluidThatWeWriteBitByBit) {
  expectRoundTrip<1>(5, 3);
  expectRoundTrip<2>(1, 0);
  expectRoundTrip<2>(10000, 922);   // 10922 points of 24 bytes: a block of 256 KiB less 16 bytes
  expectRoundTrip<3>(20000, 1845);  // over the end of the second block
}

TEST(VtuReader, ReadsTextAndBase64) {
  const auto points =
      readVtuPoints(
          fileWith(
              "<DataArray type='Float32' NumberOfComponents='3'>\n 1 2e-3\t-3\n4 5 6 </DataArray>"),
          "a.vtu")
          .positions;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0], (Vec<3>{{1, 2e-3, -3}}));
  EXPECT_EQ(points[1], (Vec<3>{{4, 5, 6}}));
  // UInt32 6, then the bytes 1 to 6, in one text: "BgAAAA" + "ECAwQFBg" by RFC 4648.
  const auto bytes =
      readVtuPoints(fileWith("<DataArray type='UInt8' NumberOfComponents='3' format='binary'>\n"
                             "BgAAAAECAwQFBg==\n</DataArray>"),
                    "a.vtu")
          .positions;
  ASSERT_EQ(bytes.size(), 2u);
  EXPECT_EQ(bytes[0], (Vec<3>{{1, 2, 3}}));
  EXPECT_EQ(bytes[1], (Vec<3>{{4, 5, 6}}));
}

TEST(VtuReader, ATypeOfOtherNumbersIsNoWall) {
  const std::string points =
      "<DataArray type='Float32' NumberOfComponents='3'>1 2 3 4 5 6</DataArray></Points><PointData>"
      "<DataArray Name='type' type='Int32'>";
  const auto read = [&](const std::string& types) {
    return readVtuPoints(fileWith(points + types + "</DataArray></PointData><Points>"), "a.vtu");
  };
  EXPECT_EQ(read("1 0").nWalls, 1u);
  EXPECT_EQ(read("1 0").positions.at(0)[0], 4);
  EXPECT_EQ(read("1 2").nWalls, 0u);
  EXPECT_EQ(read("1 2").positions.size(), 2u);
}

TEST(VtuReader, SaysWhatItCannotRead) {
  const std::string array = "<DataArray type='Float32' NumberOfComponents='3'>1 2 3 4 5";
  EXPECT_NE(messageOf("solid cube").find("no VTK file"), std::string::npos);
  EXPECT_NE(messageOf(fileWith("", "byte_order='BigEndian'")).find("big-endian"),
            std::string::npos);
  EXPECT_NE(messageOf(fileWith("", "compressor='vtkLZ4DataCompressor'")).find("LZ4"),
            std::string::npos);
  EXPECT_NE(messageOf(fileWith("", "header_type='UInt8'")).find("UInt8"), std::string::npos);
  EXPECT_NE(messageOf(fileWith("")).find("without Points"), std::string::npos);
  EXPECT_NE(messageOf(fileWith(array + "</DataArray>")).find("5 values, must have 6"),
            std::string::npos);
  EXPECT_NE(messageOf(fileWith(array + " x</DataArray>")).find("'x' is not a number"),
            std::string::npos);
  EXPECT_NE(messageOf(fileWith("<DataArray type='Float32' NumberOfComponents='2'/>"))
                .find("three components"),
            std::string::npos);
  EXPECT_NE(messageOf(fileWith("<DataArray type='Float32' NumberOfComponents='3' "
                               "format='appended' offset='0'/>"))
                .find("truncated"),
            std::string::npos);
  EXPECT_NE(messageOf("<VTKFile type='UnstructuredGrid'").find("truncated"), std::string::npos);
}

TEST(VtuReader, DamageIsAnErrorWhereverItIs) {
  const TemporaryFolder folder;
  writeVtu(folder.path() / "sample.vtu", sampleScene<2>(-1, 1, 40, 0).particles);
  const std::string whole = bytesOf(folder.path() / "sample.vtu");
  ASSERT_EQ(messageOf(whole), "");
  const std::size_t data = whole.find("\n_") + 2;
  for (std::size_t length = 0; length <= data + 100; ++length)
    EXPECT_NE(messageOf(whole.substr(0, length)), "") << length;
  // Every byte of the points' header (three words and the length of one block) counts.
  for (std::size_t k = 0; k < 32; ++k) {
    std::string damaged = whole;
    damaged[data + k] = static_cast<char>(damaged[data + k] ^ 0x55);
    // Bytes a block may be anything if the last, only block is short
    if (k >= 8 && k < 16) continue;
    EXPECT_NE(messageOf(damaged), "") << k;
  }
}

}  // namespace
}  // namespace plenum
