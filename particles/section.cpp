// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/section.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

std::string Range::printed() const {
  const bool hasLower = std::isfinite(lower);
  const bool hasUpper = std::isfinite(upper);
  if (!hasLower && !hasUpper) return "";
  if (!hasUpper) return fmt::format("{} {}", lowerExcluded ? ">" : ">=", lower);
  if (!hasLower) return fmt::format("<= {}", upper);
  return fmt::format("in {}{}, {}]", lowerExcluded ? "(" : "[", lower, upper);
}

namespace section_detail {

void checkNumber(const CaseNode& node, double value, const Range& range, const std::string& unit) {
  if (std::isfinite(value) && range.has(value)) return;
  const std::string inUnit = unit.empty() ? "" : " [" + unit + "]";
  if (!std::isfinite(value)) node.fail("must be a finite number" + inUnit);
  node.fail("must be " + range.printed() + inUnit);
}

void checkChoice(const CaseNode& node, std::span<const std::string> choices) {
  const std::string& value = node.asString();
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
  const std::string near = nearest(value, choices);
  node.fail("must be one of " + printChoices(choices) +
            (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
}

void checkKeys(const CaseNode& table, const std::vector<ParameterDoc>& docs) {
  std::vector<std::string> known;
  for (const ParameterDoc& doc : docs) known.push_back(doc.key);
  for (const auto& [key, node] : table.asTable()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string near = nearest(key, known);
    node.fail("unknown key '" + key + "'" +
              (near.empty() ? "; known here: " + fmt::format("{}", fmt::join(known, ", "))
                            : "; did you mean '" + near + "'?"));
  }
  for (const ParameterDoc& doc : docs)
    if (doc.required && table.find(doc.key) == nullptr)
      table.fail(fmt::format("the key '{}' is missing: {}{}", doc.key, doc.description,
                             doc.unit.empty() ? "" : " [" + doc.unit + "]"));
}

int asInt(const CaseNode& node, std::int64_t value) {
  constexpr std::int64_t largest = std::numeric_limits<int>::max();
  if (value > largest || value < -largest) node.fail(fmt::format("must be within +-{}", largest));
  return static_cast<int>(value);
}

std::vector<double> readVector(const CaseNode& node, int dimension) {
  std::vector<double> values;
  for (const CaseNode& item : node.asArray()) {
    values.push_back(item.asNumber());
    checkNumber(item, values.back(), Range::any(), "");
  }
  if (static_cast<int>(values.size()) != dimension)
    node.fail(
        fmt::format("has {} components, the case has {} dimensions", values.size(), dimension));
  return values;
}

std::vector<double> readList(const CaseNode& node, const Range& range, const std::string& unit) {
  std::vector<double> values;
  for (const CaseNode& item : node.asArray()) {
    values.push_back(item.asNumber());
    checkNumber(item, values.back(), range, unit);
  }
  return values;
}

std::string printNumber(double value) { return fmt::format("{}", value); }

std::string printChoices(std::span<const std::string> choices) {
  return fmt::format("{}", fmt::join(choices, " | "));
}

}  // namespace section_detail

std::string SectionDoc::printed(int indent) const {
  const std::string name = isList ? fmt::format("[[{}]]", key) : key;
  std::string text =
      fmt::format("{:{}}{}{}\n", "", indent, key.empty() ? "" : name + "  ", description);
  for (const ParameterDoc& p : parameters) {
    const bool isTable = std::any_of(inner.begin(), inner.end(),
                                     [&](const SectionDoc& doc) { return doc.key == p.key; });
    if (isTable) continue;
    std::string facts = p.type;
    if (!p.unit.empty()) facts += " [" + p.unit + "]";
    if (!p.range.empty()) facts += " " + p.range;
    if (p.required) facts += ", required";
    if (!p.defaultValue.empty()) facts += ", default " + p.defaultValue;
    text += fmt::format("{:{}}{:<22} {} ({})\n", "", indent + 2, p.key, p.description, facts);
  }
  for (const SectionDoc& doc : inner) text += doc.printed(indent + 2);
  return text;
}

namespace {

/// Text for a cell of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\\|");
  return text;
}

}  // namespace

std::string SectionDoc::markdown(const std::string& prefix) const {
  const std::string path = prefix.empty() ? key : prefix + "." + key;
  std::string text = path.empty()
                         ? "### Top level\n\n"
                         : fmt::format("### `{}`\n\n", isList ? fmt::format("[[{}]]", path) : path);
  text += description + "\n\n";
  text += "| key | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n";
  for (const ParameterDoc& p : parameters)
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", p.key, p.type, p.unit, cell(p.range),
                        p.required ? "required" : p.defaultValue, cell(p.description));
  text += "\n";
  for (const SectionDoc& doc : inner) text += doc.markdown(path);
  return text;
}

}  // namespace plenum
