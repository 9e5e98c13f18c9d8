// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/text_reader.hpp"

#include "particles/errors.hpp"
#include "particles/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>

namespace plenum {

std::string extensionOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return std::tolower(c); });
  return extension;
}

std::ifstream openFile(const std::filesystem::path& path, double memoryPerByte) {
  namespace fs = std::filesystem;
  const std::string name = path.string();
  if (!fs::exists(path))
    throw InputError(name + ": no such file; paths are relative to the case file");
  if (!fs::is_regular_file(path)) throw InputError(name + ": is not a file; give the path of one");
  if (fs::file_size(path) == 0) throw InputError(name + ": is empty; export it again");
  const double needed = memoryPerByte * static_cast<double>(fs::file_size(path));
  const double available = availableMemory().value_or(needed);
  if (needed > available)
    throw InputError(
        fmt::format("{}: is too large: its {} need about {} of memory, {} are available; export a "
                    "coarser one",
                    name, printedBytes(static_cast<double>(fs::file_size(path))),
                    printedBytes(needed), printedBytes(available)));
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(name + ": cannot be read; check its permissions");
  return in;
}

std::string readWholeFile(const std::filesystem::path& path, double memoryPerByte) {
  std::ifstream in = openFile(path, memoryPerByte);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in || !bytes) throw InputError(path.string() + ": cannot be read; check its permissions");
  return bytes.str();
}

namespace {
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// A word as messages show it: short and printable.
std::string shown(std::string_view word) {
  std::string text(word.substr(0, 20));
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return text + (word.size() > 20 ? "..." : "");
}
}  // namespace

void TextReader::skipBlanks(char comment) {
  while (!rest_.empty()) {
    if (comment != '\0' && rest_.front() == comment)
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
    else if (!isBlank(rest_.front()))
      return;
    else {
      if (rest_.front() == '\n') ++line_;
      rest_.remove_prefix(1);
    }
  }
}

std::string_view TextReader::word(char comment) {
  skipBlanks(comment);
  std::size_t length = 0;
  while (length < rest_.size() && !isBlank(rest_[length]) &&
         (comment == '\0' || rest_[length] != comment))
    ++length;
  const std::string_view result = rest_.substr(0, length);
  rest_.remove_prefix(length);
  return result;
}

std::string_view TextReader::restOfLine() {
  const std::size_t length = std::min(rest_.find('\n'), rest_.size());
  std::string_view result = rest_.substr(0, length);
  if (length < rest_.size()) ++line_;
  rest_.remove_prefix(std::min(length + 1, rest_.size()));
  if (!result.empty() && result.back() == '\r') result.remove_suffix(1);
  return result;
}

double TextReader::number(char comment) {
  const std::string_view text = word(comment);
  if (text.empty()) fail("the file ends where a number is expected: truncated? export it again");
  return toNumber(text);
}

double TextReader::toNumber(std::string_view text) const {
  double value = 0;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end) fail("'" + shown(text) + "' is not a number");
  if (!std::isfinite(value))
    fail("'" + shown(text) + "' is not a finite number; coordinates must be finite");
  return value;
}

std::size_t TextReader::count(char comment) {
  const std::string_view text = word(comment);
  if (text.empty()) fail("the file ends where a count is expected: truncated? export it again");
  std::size_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size())
    fail("'" + shown(text) + "' is not a whole number");
  return value;
}

bool TextReader::atEnd() {
  skipBlanks('\0');
  return rest_.empty();
}

void TextReader::fail(const std::string& message) const {
  throw InputError(fmt::format("{}:{}: {}", source_, line_, message));
}

}  // namespace plenum
