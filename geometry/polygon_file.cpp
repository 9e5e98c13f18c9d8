// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon_file.hpp"

#include "geometry/text_reader.hpp"

#include <algorithm>
#include <cctype>
#include <string>

namespace plenum {

namespace {

/// Well-known text; parentheses and commas are words of their own in `text`, which must outlive
/// this.
class WktReader {
 public:
  WktReader(std::string_view text, const std::string& source) : words_(text, source) {}

  std::vector<PolygonLoops> read() {
    const std::string kind = lower(words_.word());
    std::vector<PolygonLoops> polygons;
    if (kind == "polygon")
      polygons.push_back(polygon());
    else if (kind == "multipolygon")
      list([&] { polygons.push_back(polygon()); });
    else if (kind.ends_with("linestring"))
      words_.fail("'" + kind +
                  "' is an open line, which has no inside; for a thin wall along it give its "
                  "thickness beside file, for a closed region write POLYGON");
    else
      words_.fail("'" + kind.substr(0, 20) +
                  "' is not a polygon; expected POLYGON, MULTIPOLYGON or lines of x y");
    if (!words_.atEnd())
      words_.fail("there is more after the polygon; use MULTIPOLYGON for several");
    return polygons;
  }

  std::vector<Loop> readLines() {
    const std::string kind = lower(words_.word());
    std::vector<Loop> lines;
    if (kind == "linestring")
      lines.push_back(corners());
    else if (kind == "multilinestring")
      list([&] { lines.push_back(corners()); });
    else if (kind.ends_with("polygon"))
      words_.fail(
          "is a closed polygon, and thickness is for open lines; remove thickness to have "
          "the region inside it, or write LINESTRING for a wall along an open line");
    else
      words_.fail("'" + kind.substr(0, 20) +
                  "' is not a line; expected LINESTRING, MULTILINESTRING or lines of x y");
    if (!words_.atEnd())
      words_.fail("there is more after the line; use MULTILINESTRING for several");
    return lines;
  }

 private:
  static std::string lower(std::string_view word) {
    std::string text(word);
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
  }

  void expect(std::string_view wanted) {
    const std::string_view found = words_.word();
    if (found == wanted) return;
    if (found.empty()) words_.fail("the file ends inside a polygon: truncated? export it again");
    const std::string name = lower(found);
    if (name == "z" || name == "m" || name == "zm")
      words_.fail("coordinates must be x y: export a 2-D polygon");
    words_.fail("expected '" + std::string(wanted) + "', found '" + name.substr(0, 20) +
                "'; every corner is two numbers x y");
  }

  /// "( item , item ... )"
  template <class Item>
  void list(Item&& item) {
    expect("(");
    while (true) {
      item();
      const std::string_view next = words_.word();
      if (next == ")") return;
      if (next.empty()) words_.fail("the file ends inside a polygon: truncated? export it again");
      if (next != ",")
        words_.fail("expected ',' or ')', found '" + std::string(next.substr(0, 20)) +
                    "'; every corner is two numbers x y");
    }
  }

  PolygonLoops polygon() {
    std::vector<Loop> rings;
    list([&] { rings.push_back(corners()); });
    return {rings.front(), {rings.begin() + 1, rings.end()}};
  }

  Loop corners() {
    Loop ring;
    list([&] {
      const double x = words_.number();
      ring.push_back({{x, words_.number()}});
    });
    return ring;
  }

  TextReader words_;
};

std::vector<Loop> readPlainLoops(std::string_view text, const std::string& source) {
  TextReader lines(text, source);
  std::vector<Loop> loops;
  bool parted = true;
  while (!lines.rest().empty()) {
    const int number = lines.line();
    std::string line(lines.restOfLine());
    const bool isComment = line.find('#') != std::string::npos;
    line.erase(std::min(line.find('#'), line.size()));
    std::ranges::replace(line, ',', ' ');
    TextReader words(line, source + ":" + std::to_string(number));
    std::vector<double> row;
    while (!words.atEnd()) row.push_back(words.toNumber(words.word()));
    if (row.empty()) {
      parted = parted || !isComment;  // a comment alone does not part loops
      continue;
    }
    if (row.size() != 2)
      words.fail("has " + std::to_string(row.size()) + " number" + (row.size() == 1 ? "" : "s") +
                 ", a corner is two: x y");
    if (parted) loops.emplace_back();
    parted = false;
    loops.back().push_back({{row[0], row[1]}});
  }
  return loops;
}

std::string readText(const std::filesystem::path& path) {
  const std::string text = readWholeFile(path);
  if (text.find('\0') != std::string::npos)
    TextReader("", path.string()).fail("is not text; a polygon file is WKT or lines of x y");
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    TextReader("", path.string()).fail("holds no polygon; export the geometry again");
  return text;
}

bool isWkt(const std::string& text) {
  return std::isalpha(static_cast<unsigned char>(text[text.find_first_not_of(" \t\r\n")]));
}

/// Parentheses and commas made words of their own.
std::string parted(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '(' || c == ')' || c == ',')
      result += {' ', c, ' '};
    else
      result += c;
  }
  return result;
}

}  // namespace

std::vector<PolygonLoops> readPolygonFile(const std::filesystem::path& path) {
  const std::string text = readText(path);
  const std::string source = path.string();
  if (!isWkt(text)) return nestedLoops(readPlainLoops(text, source), source);
  const std::string words = parted(text);
  return WktReader(words, source).read();
}

std::vector<Loop> readLineFile(const std::filesystem::path& path) {
  const std::string text = readText(path);
  const std::string source = path.string();
  if (!isWkt(text)) return readPlainLoops(text, source);
  const std::string words = parted(text);
  return WktReader(words, source).readLines();
}

}  // namespace plenum
