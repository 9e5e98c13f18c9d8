// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/vtk_xml.hpp"

#include "particles/errors.hpp"

#include <algorithm>

namespace plenum {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Length of a tag up to its '>', which may stand in quotes before; npos if it never ends.
std::size_t lengthOfTag(std::string_view tag) {
  char quote = '\0';
  for (std::size_t k = 0; k < tag.size(); ++k) {
    const char c = tag[k];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return k;
    }
  }
  return std::string_view::npos;
}

void skipBlanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
}

}  // namespace

std::optional<std::string_view> VtkElement::attribute(std::string_view key) const {
  std::string_view rest = attributes;
  while (true) {
    skipBlanks(rest);
    const std::size_t equals = rest.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    std::string_view found = rest.substr(0, equals);
    found = found.substr(0, found.find_last_not_of(blanks) + 1);
    rest.remove_prefix(equals + 1);
    skipBlanks(rest);
    if (rest.empty()) return std::nullopt;
    const std::size_t end = rest.find(rest.front(), 1);
    if (end == std::string_view::npos) return std::nullopt;
    if (found == key) return rest.substr(1, end - 1);
    rest.remove_prefix(end + 1);
  }
}

void VtkXml::skipComments() {
  while (rest_.starts_with("<!--")) {
    const std::size_t end = rest_.find("-->");
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 3);
    rest_.remove_prefix(std::min(rest_.find('<'), rest_.size()));
  }
}

std::optional<VtkElement> VtkXml::next() {
  rest_.remove_prefix(std::min(rest_.find('<'), rest_.size()));
  skipComments();
  if (rest_.empty()) return std::nullopt;
  rest_.remove_prefix(1);
  const std::size_t length = lengthOfTag(rest_);
  if (length == std::string_view::npos)
    throw InputError(source_ + ": ends within a tag: truncated? export it again");
  const std::string_view tag = rest_.substr(0, length);
  rest_.remove_prefix(length + 1);
  VtkElement element;
  element.name = tag.substr(0, tag.find_first_of(" \t\r\n/", 1));
  element.attributes = tag.substr(element.name.size());
  element.text =
      rest_.substr(0, element.name == "AppendedData" ? std::string_view::npos : rest_.find('<'));
  rest_.remove_prefix(element.text.size());
  return element;
}

}  // namespace plenum
