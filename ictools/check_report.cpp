// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace plenum {

namespace {

constexpr Severity worstFirst[] = {Severity::error, Severity::warning, Severity::note};

/// "2 errors, 1 warning", or "sound".
std::string verdict(const Findings& findings) {
  std::vector<std::string> counts;
  for (const Severity severity : worstFirst)
    if (const std::size_t n = findings.count(severity))
      counts.push_back(fmt::format("{} {}{}", n, nameOf(severity), n == 1 ? "" : "s"));
  const std::string all = fmt::format("{}", fmt::join(counts, ", "));
  if (findings.hasErrors()) return all;
  return all.empty() ? "sound" : "sound; " + all;
}

}  // namespace

std::string describe(const CheckReport& report) {
  std::string text = fmt::format("{}: {}\n", report.caseName, verdict(report.findings));
  for (const Severity severity : worstFirst)
    for (const Finding& finding : report.findings.all()) {
      if (finding.severity != severity) continue;
      text += fmt::format("  {:<8} {}\n", nameOf(severity), finding.what);
      if (!finding.remedy.empty()) text += fmt::format("           -> {}\n", finding.remedy);
    }
  for (const PartSize& part : report.parts)
    text += fmt::format("  part     {}: {:.4g} m, {:.4g} d_ref, {}\n", part.name,
                        fmt::join(part.extent, " x "), fmt::join(part.extentInSpacings, " x "),
                        part.description);
  return report.estimate ? text + describe(*report.estimate) : text;
}

std::string toJson(const CheckReport& report) {
  using Json = nlohmann::ordered_json;
  Json json{{"case", report.caseName},
            {"sound", !report.findings.hasErrors()},
            {"findings", Json::array()},
            {"parts", Json::array()},
            {"estimate", nullptr}};
  for (const Finding& finding : report.findings.all())
    json["findings"].push_back({{"severity", nameOf(finding.severity)},
                                {"what", finding.what},
                                {"remedy", finding.remedy},
                                {"place", finding.place}});
  for (const PartSize& part : report.parts)
    json["parts"].push_back({{"name", part.name},
                             {"description", part.description},
                             {"extent", part.extent},
                             {"extent_in_spacings", part.extentInSpacings}});
  if (const auto& estimate = report.estimate)
    json["estimate"] = {{"fluid_particles", estimate->nFluid},
                        {"wall_particles", estimate->nWalls},
                        {"counted", estimate->isCounted},
                        {"neighbours", estimate->neighbours},
                        {"generate_bytes", estimate->generateMemory},
                        {"run_bytes", estimate->runMemory},
                        {"step_seconds", estimate->stepTime}};
  // Names of files may hold bytes that are no UTF-8: shown as a question mark rather than thrown.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plenum
