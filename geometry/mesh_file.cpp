// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh_file.hpp"

#include "geometry/text_reader.hpp"
#include "particles/errors.hpp"
#include "particles/memory.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstring>

namespace plenum {

namespace {

// Measured with spheres of 4e5 triangles: checks, mesh and search tree took 660 bytes a triangle at
// most, of which an ASCII STL file has 260.
constexpr double memoryPerTriangle = 660;
constexpr double memoryPerByte = 2.5;

/// Throws InputError if the memory does not suffice for so many triangles.
void checkCount(double nTriangles, const std::string& source) {
  const double needed = memoryPerTriangle * nTriangles;
  const double available = availableMemory().value_or(needed);
  if (needed > available)
    throw InputError(
        fmt::format("{}: is too large: its {:.3g} triangles need about {} of memory, {} are "
                    "available; export it with fewer triangles",
                    source, nTriangles, printedBytes(needed), printedBytes(available)));
}

Vec<3> readPoint(TextReader& words, char comment = '\0') {
  const double x = words.number(comment);
  const double y = words.number(comment);
  return {{x, y, words.number(comment)}};
}

TriangleSoup readAsciiStl(const std::string& text, const std::string& source) {
  TextReader words(text, source);
  words.restOfLine();  // solid NAME
  TriangleSoup soup;
  bool closed = false;
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
    if (word == "vertex") {
      soup.points.push_back(readPoint(words));
    } else if (word == "endfacet") {
      const std::size_t n = soup.points.size();
      if (n != 3 * soup.triangles.size() + 3) words.fail("a facet must have three vertices");
      soup.triangles.push_back({n - 3, n - 2, n - 1});
    } else if (word == "endsolid" || word == "solid") {
      closed = word == "endsolid";
      words.restOfLine();
    } else if (word == "normal") {
      for (int k = 0; k < 3; ++k) words.word();  // often wrong; the corners' order counts
    } else if (word != "facet" && word != "outer" && word != "loop" && word != "endloop") {
      words.fail(fmt::format("'{}' has no place in an STL file", word.substr(0, 20)));
    }
  }
  if (!closed) words.fail("the file ends without endsolid: truncated? export it again");
  return soup;
}

}  // namespace

void addFace(TriangleSoup& soup, const std::vector<std::size_t>& corners, std::size_t nPoints,
             const std::string& source) {
  if (corners.size() < 3)
    throw InputError(
        fmt::format("{}: a face has {} corners; it needs 3 or more", source, corners.size()));
  for (std::size_t corner : corners)
    if (corner >= nPoints)
      throw InputError(
          fmt::format("{}: a face names corner {}, but there are {} points: truncated? "
                      "export it again",
                      source, corner, nPoints));
  for (std::size_t k = 2; k < corners.size(); ++k)
    soup.triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

TriangleSoup readStl(const std::string& bytes, const std::string& source) {
  // Binary files may begin with "solid" too: the length tells them apart.
  constexpr std::size_t header = 84;
  constexpr std::size_t perTriangle = 50;
  std::uint32_t n = 0;
  if (bytes.size() >= header) std::memcpy(&n, bytes.data() + 80, 4);
  const std::size_t expected = header + perTriangle * std::size_t(n);
  const bool looksBinary = bytes.find('\0') != std::string::npos;
  if (!looksBinary && bytes.starts_with("solid")) return readAsciiStl(bytes, source);
  if (bytes.size() < header || (!looksBinary && bytes.size() != expected))
    throw InputError(source +
                     ": is not an STL file; it begins neither with 'solid' nor with a "
                     "binary header");
  if (bytes.size() < expected)
    throw InputError(
        fmt::format("{}: is truncated (or no STL file): {} triangles need {} bytes, it "
                    "has {}; export it again",
                    source, n, expected, bytes.size()));
  checkCount(n, source);
  TriangleSoup soup;
  for (std::size_t t = 0; t < n; ++t) {
    float corners[9];
    std::memcpy(corners, bytes.data() + header + t * perTriangle + 12, sizeof corners);
    for (std::size_t k = 0; k < 3; ++k)
      soup.points.push_back({{corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]}});
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return soup;
}

TriangleSoup readObj(const std::string& bytes, const std::string& source) {
  TextReader lines(bytes, source);
  TriangleSoup soup;
  while (!lines.rest().empty()) {
    const std::string where = fmt::format("{}:{}", source, lines.line());
    TextReader words(lines.restOfLine(), where);
    const std::string_view kind = words.word('#');
    if (kind == "v") soup.points.push_back(readPoint(words, '#'));
    if (kind != "f") continue;
    std::vector<std::size_t> corners;
    for (std::string_view word = words.word('#'); !word.empty(); word = words.word('#')) {
      word = word.substr(0, word.find('/'));  // point/texture/normal
      long number = 0;
      const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
      if (error != std::errc{} || stop != word.data() + word.size() || number == 0)
        words.fail(fmt::format("'{}' is not the number of a point", word.substr(0, 20)));
      const long n = static_cast<long>(soup.points.size());
      corners.push_back(static_cast<std::size_t>(number > 0 ? number - 1 : n + number));
    }
    addFace(soup, corners, soup.points.size(), where);
  }
  if (soup.points.empty())
    throw InputError(source + ": is not an OBJ file with points (no line 'v x y z')");
  return soup;
}

TriangleSoup readOff(const std::string& bytes, const std::string& source) {
  TextReader words(bytes, source);
  if (words.word('#') != "OFF") words.fail("is not an OFF file: it does not begin with 'OFF'");
  const std::size_t nPoints = words.count('#');
  const std::size_t nFaces = words.count('#');
  words.count('#');  // edges: often 0
  TriangleSoup soup;
  for (std::size_t k = 0; k < nPoints; ++k) soup.points.push_back(readPoint(words, '#'));
  for (std::size_t k = 0; k < nFaces; ++k) {
    const std::size_t nCorners = words.count('#');
    if (nCorners > nPoints) words.fail("a face has more corners than there are points");
    std::vector<std::size_t> corners(nCorners);
    for (std::size_t& corner : corners) corner = words.count('#');
    addFace(soup, corners, nPoints, fmt::format("{}:{}", source, words.line()));
    words.restOfLine();  // colours
  }
  return soup;
}

TriangleSoup readMeshFile(const std::filesystem::path& path) {
  const std::string bytes = readWholeFile(path, memoryPerByte);
  const std::string source = path.string();
  const std::string extension = extensionOf(path);
  if (extension == ".stl") return readStl(bytes, source);
  if (extension == ".obj") return readObj(bytes, source);
  if (extension == ".off") return readOff(bytes, source);
  return readPly(bytes, source);
}

}  // namespace plenum
