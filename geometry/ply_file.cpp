// SPDX-License-Identifier: GPL-3.0-or-later
//
// PLY: a text header that lists elements and their properties, then the values as text or binary.
#include "geometry/mesh_file.hpp"
#include "geometry/text_reader.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace plenum {

namespace {

enum class Number { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Number type{};
  bool isList = false;
  Number countType{};
};

struct Element {
  std::string name;
  std::size_t n = 0;
  std::vector<Property> properties;
};

struct Header {
  std::string format;
  std::vector<Element> elements;
};

Number numberNamed(std::string_view name, const TextReader& words) {
  static constexpr std::pair<std::string_view, Number> names[] = {
      {"char", Number::int8},      {"int8", Number::int8},       {"uchar", Number::uint8},
      {"uint8", Number::uint8},    {"short", Number::int16},     {"int16", Number::int16},
      {"ushort", Number::uint16},  {"uint16", Number::uint16},   {"int", Number::int32},
      {"int32", Number::int32},    {"uint", Number::uint32},     {"uint32", Number::uint32},
      {"float", Number::float32},  {"float32", Number::float32}, {"double", Number::float64},
      {"float64", Number::float64}};
  for (const auto& [known, number] : names)
    if (known == name) return number;
  words.fail(fmt::format("'{}' is not a PLY number type", name.substr(0, 20)));
}

Header readHeader(TextReader& words) {
  Header header;
  if (words.restOfLine() != "ply") words.fail("is not a PLY file: it does not begin with 'ply'");
  while (true) {
    const std::string_view word = words.word();
    if (word == "end_header") break;
    if (word.empty()) words.fail("the header has no end: truncated? export it again");
    if (word == "format") {
      header.format = words.word();
    } else if (word == "element") {
      Element element{std::string(words.word()), 0, {}};
      element.n = words.count();
      header.elements.push_back(element);
    } else if (word == "property" && !header.elements.empty()) {
      Property property;
      std::string_view type = words.word();
      if (type == "list") {
        property.isList = true;
        property.countType = numberNamed(words.word(), words);
        type = words.word();
      }
      property.type = numberNamed(type, words);
      property.name = words.word();
      header.elements.back().properties.push_back(property);
    }
    words.restOfLine();
  }
  words.restOfLine();
  return header;
}

/// Values one after the other, from text or bytes.
class Values {
 public:
  Values(TextReader& words, const std::string& format)
      : words_(words), bytes_(words.rest()), isText_(format == "ascii") {
    if (!isText_ && format != "binary_little_endian" && format != "binary_big_endian")
      words.fail(fmt::format("'{}' is not a PLY format", format));
    swapped_ = (format == "binary_big_endian") != (std::endian::native == std::endian::big);
  }

  double next(Number type) {
    if (isText_) return words_.number();
    switch (type) {
      case Number::int8:
        return take<std::int8_t>();
      case Number::uint8:
        return take<std::uint8_t>();
      case Number::int16:
        return take<std::int16_t>();
      case Number::uint16:
        return take<std::uint16_t>();
      case Number::int32:
        return take<std::int32_t>();
      case Number::uint32:
        return take<std::uint32_t>();
      case Number::float32:
        return take<float>();
      default:
        return take<double>();
    }
  }

 private:
  template <class T>
  double take() {
    if (bytes_.size() < sizeof(T)) words_.fail("is truncated: values are missing; export it again");
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data(), sizeof(T));
    if (swapped_) std::reverse(raw, raw + sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return static_cast<double>(value);
  }

  TextReader& words_;
  std::string_view bytes_;
  bool isText_;
  bool swapped_ = false;
};

/// How many values a property has here.
std::size_t lengthOf(const Property& property, Values& values, const std::string& source) {
  if (!property.isList) return 1;
  const double length = values.next(property.countType);
  if (!(length >= 0 && length < 1e6))
    throw InputError(source + ": a list has no sensible length; export it again");
  return static_cast<std::size_t>(length);
}

void readVertex(TriangleSoup& soup, const Element& element, Values& values,
                const std::string& source) {
  Vec<3> x;
  for (const Property& property : element.properties) {
    const std::size_t n = lengthOf(property, values, source);
    for (std::size_t k = 0; k < n; ++k) {
      const double value = values.next(property.type);
      if (property.name == "x") x[0] = value;
      if (property.name == "y") x[1] = value;
      if (property.name == "z") x[2] = value;
    }
  }
  soup.points.push_back(x);
}

/// Reads one face, or one instance of an element that does not matter.
void readOther(TriangleSoup& soup, const Element& element, Values& values,
               const std::string& source) {
  for (const Property& property : element.properties) {
    const std::size_t n = lengthOf(property, values, source);
    std::vector<std::size_t> corners;
    for (std::size_t k = 0; k < n; ++k) {
      const double value = values.next(property.type);
      corners.push_back(value >= 0 && value < 1e15 ? static_cast<std::size_t>(value) : SIZE_MAX);
    }
    if (element.name == "face" && property.name.starts_with("vertex_ind"))
      addFace(soup, corners, soup.points.size(), source);
  }
}

}  // namespace

TriangleSoup readPly(const std::string& bytes, const std::string& source) {
  TextReader words(bytes, source);
  const Header header = readHeader(words);
  Values values(words, header.format);
  TriangleSoup soup;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;  // whatever their number, they have no values
    for (std::size_t k = 0; k < element.n; ++k) {
      if (element.name == "vertex")
        readVertex(soup, element, values, source);
      else
        readOther(soup, element, values, source);
    }
  }
  if (soup.points.empty()) throw InputError(source + ": holds no points; export a surface mesh");
  return soup;
}

}  // namespace plenum
