// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh_file.hpp"
#include "files_for_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace plenum::test {
namespace {

/// A tetrahedron: volume 1/6.
const std::vector<Vec<3>> corners = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
const std::vector<std::array<std::size_t, 3>> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

template <class T>
std::string bytesOf(T value, bool swapped = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (swapped) std::reverse(raw, raw + sizeof(T));
  return std::string(raw, sizeof(T));
}

std::string asciiStl() {
  std::string text = "solid tetrahedron\n";
  for (const auto& face : faces) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (std::size_t k : face)
      text += fmt::format("  vertex {} {} {:.3e}\n", corners[k][0], corners[k][1], corners[k][2]);
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

std::string binaryStl() {
  std::string bytes = "solid but binary";  // some programs begin binary files with this word
  bytes.resize(80, '\0');
  bytes += bytesOf(std::uint32_t(faces.size()));
  for (const auto& face : faces) {
    bytes += std::string(12, '\0');
    for (std::size_t k : face)
      for (int a = 0; a < 3; ++a) bytes += bytesOf(static_cast<float>(corners[k][a]));
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string obj() {
  return "# comment\nmtllib none\nv 0 0 0\nv 1 0 0 # x\nv 0 1 0\nv 0 0 1\nvn 0 0 1\n"
         "f 1 3 2\nf 1//1 2//1 4//1\nf 2/1/1 3/1/1 4/1/1\nf -2 -4 -1\n";
}

std::string off() {
  return "OFF\n# comment\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3 255 0 0\n3 1 2 3\n3 "
         "2 0 3\n";
}

std::string ply(const std::string& format) {
  std::string bytes =
      "ply\nformat " + format +
      " 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty "
      "float y\nproperty double z\nproperty uchar red\nelement face 4\nproperty list "
      "uchar int vertex_indices\nend_header\n";
  const bool swapped = format == "binary_big_endian";
  for (const Vec<3>& x : corners) {
    if (format == "ascii")
      bytes += fmt::format("{} {} {} 7\n", x[0], x[1], x[2]);
    else
      bytes += bytesOf(float(x[0]), swapped) + bytesOf(float(x[1]), swapped) +
               bytesOf(x[2], swapped) + '\7';
  }
  for (const auto& face : faces) {
    if (format == "ascii") {
      bytes += fmt::format("3 {} {} {}\n", face[0], face[1], face[2]);
      continue;
    }
    bytes += '\3';
    for (std::size_t k : face) bytes += bytesOf(std::int32_t(k), swapped);
  }
  return bytes;
}

void expectTetrahedron(const std::string& name, const std::string& content) {
  const auto geometry = readGeometryFile<3>(writeFile(name, content));
  EXPECT_DOUBLE_EQ(geometry->volume().value, 1. / 6) << name;
  EXPECT_TRUE(geometry->isInside({{0.1, 0.1, 0.1}})) << name;
  EXPECT_FALSE(geometry->isInside({{0.5, 0.5, 0.5}})) << name;
}

TEST(MeshFile, ReadsEveryFormat) {
  expectTetrahedron("ascii.stl", asciiStl());
  expectTetrahedron("binary.STL", binaryStl());
  expectTetrahedron("a.obj", obj());
  expectTetrahedron("a.off", off());
  expectTetrahedron("ascii.ply", ply("ascii"));
  expectTetrahedron("little.ply", ply("binary_little_endian"));
  expectTetrahedron("big.ply", ply("binary_big_endian"));
}

TEST(MeshFile, FacesWithMoreCornersAreCut) {
  const auto cube = readGeometryFile<3>(
      writeFile("cube.off",
                "OFF 8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"));
  EXPECT_DOUBLE_EQ(cube->volume().value, 1);
}

TEST(MeshFile, FilesAreScaledAndMoved) {
  FileOptions<3> options;
  options.placement.scale = 0.001;
  options.placement.translation = {{1, 0, 0}};
  const auto geometry = readGeometryFile<3>(writeFile("a.stl", asciiStl()), options);
  EXPECT_NEAR(geometry->volume().value, 1e-9 / 6, 1e-22);  // round-off of coordinates near 1
  EXPECT_TRUE(geometry->isInside({{1.0001, 0.0001, 0.0001}}));
}

TEST(MeshFile, RefusesTruncatedFiles) {
  const auto cut = [](const std::string& bytes) { return bytes.substr(0, bytes.size() * 2 / 3); };
  expectFileError<3>("a.stl", cut(asciiStl()), {"truncated"});
  expectFileError<3>("b.stl", cut(binaryStl()), {"truncated", "284 bytes"});
  expectFileError<3>("c.off", cut(off()), {"truncated"});
  expectFileError<3>("d.ply", cut(ply("ascii")).substr(0, 230), {"truncated"});
  expectFileError<3>("e.ply", ply("binary_little_endian").substr(0, 250), {"truncated"});
  expectFileError<3>("f.ply", cut(ply("ascii")).substr(0, 60), {"truncated"});
  expectFileError<3>("g.obj", obj().substr(0, obj().size() - 12), {"not closed"});
  // Counts that the file cannot hold are found out before memory is asked for.
  expectFileError<3>("i.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n99999999999999 0 1 2\n",
                     {"i.off:6", "more corners than there are points"});
  expectFileError<3>("j.off", "OFF\n99999999999999 1 0\n0 0 0\n", {"truncated"});
  for (const char* length : {"-1", "1e300"})
    expectFileError<3>("k.ply",
                       std::string("ply\nformat ascii 1.0\nelement vertex 1\nproperty list int "
                                   "float x\nend_header\n") +
                           length + " 0\n",
                       {"no sensible length"});
  expectFileError<3>("h.obj", "v 0 0 0\nf 1 2 3\n", {":2", "corner 1", "1 points"});
}

TEST(MeshFile, RefusesOtherKindsOfFiles) {
  expectFileError<3>("a.stl", "ply\nformat ascii 1.0\n", {"is not an STL file"});
  expectFileError<3>("b.obj", "hello\n", {"is not an OBJ file"});
  expectFileError<3>("c.off", "solid\n", {"is not an OFF file"});
  expectFileError<3>("d.ply", "solid\n", {"is not a PLY file"});
  expectFileError<3>("e.stl", "", {"is empty"});
  expectFileError<3>("f.stl", "solid nothing\nendsolid\n", {"no triangles"});
  expectFileError<3>("g.xyz", "1 2 3\n", {"'.xyz' are not read", ".stl"});
  expectFileError<2>("h.stl", asciiStl(), {"3-D", "dimension = 2"});
  expectError([] { readGeometryFile<3>("none.stl"); }, {"none.stl", "no such file"});
  expectError([] { readGeometryFile<3>(writeFile("x", "").parent_path() / "y.stl/"); }, {"y.stl"});
}

TEST(MeshFile, RefusesCoordinatesThatAreNoNumbers) {
  std::string text = asciiStl();
  text.replace(text.find("vertex 0 1"), 10, "vertex nan");
  expectFileError<3>("a.stl", text, {"finite"});
  expectFileError<3>("b.obj", "v 0 0 abc\n", {":1:", "'abc' is not a number"});
  std::string bytes = binaryStl();
  bytes.replace(84 + 12, 4, bytesOf(std::numeric_limits<float>::quiet_NaN()));
  expectFileError<3>("c.stl", bytes, {"not finite"});
}

}  // namespace
}  // namespace plenum::test
