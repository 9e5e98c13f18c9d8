// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/vtk_array.hpp"

#include "particles/errors.hpp"
#include "particles/vtk_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>

namespace plenum {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// A number type of VTK: its size, and how its values become doubles.
struct NumberType {
  std::string_view name;
  std::size_t bytes;
  void (*toDoubles)(const char* data, std::vector<double>& values);
};

template <class T>
void convert(const char* data, std::vector<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    T value;
    std::memcpy(&value, data + k * sizeof(T), sizeof(T));
    values[k] = static_cast<double>(value);
  }
}

constexpr std::array<NumberType, 10> numberTypes{{
    {"Float64", 8, convert<double>},
    {"Float32", 4, convert<float>},
    {"Int8", 1, convert<std::int8_t>},
    {"UInt8", 1, convert<std::uint8_t>},
    {"Int16", 2, convert<std::int16_t>},
    {"UInt16", 2, convert<std::uint16_t>},
    {"Int32", 4, convert<std::int32_t>},
    {"UInt32", 4, convert<std::uint32_t>},
    {"Int64", 8, convert<std::int64_t>},
    {"UInt64", 8, convert<std::uint64_t>},
}};

/// Six bits of a base64 digit; -1 for other characters.
int base64Digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Decodes up to the first character that is no base64. Header and data may be two texts behind one
/// another, each padded: every group of four digits stands for itself.
std::string fromBase64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int nDigits = 0, nPadding = 0;
  for (const char c : text) {
    if (blanks.find(c) != std::string_view::npos) continue;
    const int digit = base64Digit(c);
    if (digit < 0 && c != '=') break;
    nPadding += c == '=';
    group = group << 6 | static_cast<std::uint32_t>(std::max(digit, 0));
    if (++nDigits < 4) continue;
    for (int k = 0; k < 3 - nPadding; ++k)
      bytes.push_back(static_cast<char>(group >> (16 - 8 * k) & 0xff));
    group = 0;
    nDigits = nPadding = 0;
  }
  return bytes;
}

std::vector<double> fromAscii(std::string_view text, std::size_t n, const VtkEncoding& encoding) {
  std::vector<double> values;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    if (text.empty()) break;
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || stop != word.data() + word.size())
      throw InputError(fmt::format("{}: '{}' is not a number; export the file again",
                                   encoding.source, word.substr(0, 20)));
    values.push_back(value);
    text.remove_prefix(word.size());
  }
  if (values.size() != n)
    throw InputError(fmt::format("{}: an array has {} values, must have {}; export the file again",
                                 encoding.source, values.size(), n));
  return values;
}

/// The bytes of an array from its header on; in `decoded` if they do not stand in the file so.
std::string_view encodedBytes(const VtkElement& array, std::string_view format,
                              const VtkEncoding& encoding, std::string& decoded) {
  if (format == "binary") return decoded = fromBase64(array.text);
  if (format != "appended")
    throw InputError(fmt::format(
        "{}: an array has the format \"{}\"; ascii, binary and appended are read; export it so",
        encoding.source, format));
  const std::size_t offset = countOf(array, "offset", encoding.source);
  if (offset >= encoding.appended.size())
    throw InputError(
        fmt::format("{}: an array begins at byte {} of the appended data, which have {}: "
                    "truncated? export it again",
                    encoding.source, offset, encoding.appended.size()));
  const std::string_view data = encoding.appended.substr(offset);
  if (!encoding.appendedIsBase64) return data;
  return decoded = fromBase64(data);
}

}  // namespace

std::size_t countOf(const VtkElement& element, std::string_view key, const std::string& source) {
  const std::string_view text = element.attribute(key).value_or("");
  std::size_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size())
    throw InputError(fmt::format("{}: {} has {} = \"{}\", must be a whole number; export it again",
                                 source, element.name, key, text));
  return value;
}

std::vector<double> readVtkArray(const VtkElement& array, std::size_t n,
                                 const VtkEncoding& encoding) {
  const std::string_view type = array.attribute("type").value_or("");
  const auto number = std::ranges::find(numberTypes, type, &NumberType::name);
  if (number == numberTypes.end())
    throw InputError(fmt::format(
        "{}: an array has the type \"{}\"; Float32, Float64, Int8 to Int64 and UInt8 to UInt64 are "
        "read; export it with one of them",
        encoding.source, type));
  const std::string_view format = array.attribute("format").value_or("ascii");
  if (format == "ascii") return fromAscii(array.text, n, encoding);
  std::string decoded;
  const std::string_view bytes = encodedBytes(array, format, encoding, decoded);
  const auto data = encoding.isCompressed
                        ? vtkUncompressed(bytes, encoding.headerBytes, n, number->bytes)
                        : vtkPlain(bytes, encoding.headerBytes, n, number->bytes);
  if (!data)
    throw InputError(fmt::format(
        "{}: an array does not hold the {} values of {} bytes that it must have: damaged or "
        "truncated; export it again",
        encoding.source, n, number->bytes));
  std::vector<double> values(n);
  number->toDoubles(data->data(), values);
  return values;
}

}  // namespace plenum
