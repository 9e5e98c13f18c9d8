// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/validation_report.hpp"

#include "particles/atomic_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace plenum {

namespace {

std::string percent(double share) { return fmt::format("{:.4g} %", 100 * share); }

/// "void1 at 0.1 s", "mean of f.5 from 1 s".
std::string quantityOf(const ValidateSettings& v) {
  if (v.curve) return fmt::format("{}, {} points", v.quantity, v.curve->times.size());
  if (v.time) return fmt::format("{} at {:g} s", v.quantity, *v.time);
  std::string text = v.statisticOrDefault() + " of " + v.quantity;
  if (v.from) text += fmt::format(" from {:g} s", *v.from);
  if (v.until) text += fmt::format(" until {:g} s", *v.until);
  return text;
}

std::string expectedOf(const ValidateSettings& v) {
  if (v.curve)
    return "mean distance <= " + (v.relativeTolerance ? percent(*v.relativeTolerance)
                                                      : fmt::format("{:g}", *v.tolerance));
  if (v.expected && v.relativeTolerance)
    return fmt::format("{:g} +- {}", *v.expected, percent(*v.relativeTolerance));
  if (v.expected) return fmt::format("{:g} +- {:g}", *v.expected, v.tolerance.value_or(0));
  if (v.atLeast && v.atMost) return fmt::format("{:g} to {:g}", *v.atLeast, *v.atMost);
  return v.atLeast ? fmt::format(">= {:g}", *v.atLeast) : fmt::format("<= {:g}", *v.atMost);
}

std::string measuredOf(const ValidationResult& r) {
  if (!r.measured) return "-";
  if (r.asked.curve && r.asked.relativeTolerance) return percent(*r.measured);
  return fmt::format("{:.4g}", *r.measured) + (r.unit.empty() ? "" : " " + r.unit);
}

nlohmann::ordered_json asJson(const ValidationResult& r) {
  const ValidateSettings& v = r.asked;
  nlohmann::ordered_json json{{"quantity", v.quantity}, {"unit", r.unit}};
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = *value;
  };
  if (!v.curve) json["statistic"] = v.statisticOrDefault();
  add("time", v.time);
  add("from", v.from);
  add("until", v.until);
  add("expected", v.expected);
  if (v.curve) json["curve"] = {{"times", v.curve->times}, {"values", v.curve->values}};
  add("tolerance", v.tolerance);
  add("relative_tolerance", v.relativeTolerance);
  add("at_least", v.atLeast);
  add("at_most", v.atMost);
  if (r.measured)
    json["measured"] = *r.measured;
  else
    json["measured"] = nullptr;
  json["verdict"] = nameOf(r.verdict);
  if (!v.source.empty()) json["source"] = v.source;
  return json;
}

}  // namespace

std::string printed(const std::vector<ValidationResult>& results) {
  if (results.empty()) return "";
  std::vector<std::array<std::string, 5>> rows{
      {"quantity", "expected", "measured", "verdict", "source"}};
  for (const ValidationResult& r : results)
    rows.push_back({quantityOf(r.asked), expectedOf(r.asked), measuredOf(r), nameOf(r.verdict),
                    r.asked.source});
  std::array<std::size_t, 4> width{};
  for (const auto& row : rows)
    for (std::size_t c = 0; c < width.size(); ++c) width[c] = std::max(width[c], row[c].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t c = 0; c < width.size(); ++c)
      line += fmt::format(" {:<{}} ", row[c], width[c]);
    line += " " + row[4];
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

void writeValidation(const std::filesystem::path& path,
                     const std::vector<ValidationResult>& results) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const ValidationResult& r : results) all.push_back(asJson(r));
  writeTextFile(path, all.dump(2) + "\n");
}

}  // namespace plenum
