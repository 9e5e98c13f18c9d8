// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/outcome.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

namespace plenum::study {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* outcomeFile = "outcome.json";

/// Null for a file that is not there or not whole.
Json load(const std::filesystem::path& path) {
  std::ifstream file(path);
  return file ? Json::parse(file, nullptr, false) : Json();
}

std::optional<double> numberIn(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

Json orNull(std::optional<double> value) { return value ? Json(*value) : Json(); }

std::vector<Validated> validatedIn(const Json& entries) {
  std::vector<Validated> all;
  for (const Json& entry : entries)
    all.push_back({entry.value("quantity", ""), entry.value("statistic", ""),
                   entry.value("unit", ""), entry.value("verdict", ""), numberIn(entry, "measured"),
                   numberIn(entry, "expected")});
  return all;
}

Json jsonOf(const std::vector<Validated>& all) {
  Json entries = Json::array();
  for (const Validated& v : all)
    entries.push_back({{"quantity", v.quantity},
                       {"statistic", v.statistic},
                       {"unit", v.unit},
                       {"verdict", v.verdict},
                       {"measured", orNull(v.measured)},
                       {"expected", orNull(v.expected)}});
  return entries;
}

Json jsonOf(const RunCost& cost) {
  return {{"cpu_seconds", cost.cpuSeconds},
          {"step_cpu_seconds", cost.stepCpuSeconds},
          {"wall_seconds", cost.wallSeconds},
          {"step_wall_seconds", cost.stepWallSeconds},
          {"instructions", orNull(cost.instructions)},
          {"peak_bytes", cost.peakBytes},
          {"updates_per_second", cost.updatesPerSecond},
          {"interactions_per_second", cost.interactionsPerSecond}};
}

RunCost costIn(const Json& json) {
  RunCost cost;
  cost.cpuSeconds = json.at("cpu_seconds");
  cost.stepCpuSeconds = json.at("step_cpu_seconds");
  cost.wallSeconds = json.at("wall_seconds");
  cost.stepWallSeconds = json.at("step_wall_seconds");
  cost.instructions = numberIn(json, "instructions");
  cost.peakBytes = json.at("peak_bytes");
  cost.updatesPerSecond = json.at("updates_per_second");
  cost.interactionsPerSecond = json.at("interactions_per_second");
  return cost;
}

std::map<std::string, double> figuresIn(const Json& json) {
  std::map<std::string, double> figures;
  for (const auto& [name, value] : json.items())
    if (value.is_number()) figures[name] = value.get<double>();
  return figures;
}

/// Cells of a line; no cell of history.csv holds a comma.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

double RunOutcome::figure(const std::string& name) const {
  const auto found = figures.find(name);
  return found == figures.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

void readResults(const std::filesystem::path& folder, RunOutcome& outcome) {
  outcome.folder = folder;
  if (const Json entries = load(folder / "validation.json"); entries.is_array())
    outcome.validation = validatedIn(entries);
  const Json summary = load(folder / "summary.json");
  if (!summary.is_object()) return;
  outcome.figures = figuresIn(summary.value("measures", Json::object()));
  outcome.steps = summary.value("steps", 0L);
  outcome.fluidParticles = summary.value("fluid_particles", 0L);
  outcome.wallParticles = summary.value("wall_particles", 0L);
  outcome.cost.updatesPerSecond = summary.value("updates_per_second", 0.0);
  outcome.cost.interactionsPerSecond =
      outcome.cost.updatesPerSecond * summary.value("neighbours_mean", 0.0);
  const auto steppingIn = [&](const char* seconds) {
    return summary.value(seconds, Json::object()).value("stepping", 0.0);
  };
  outcome.cost.stepCpuSeconds = steppingIn("activity_cpu_seconds");
  outcome.cost.stepWallSeconds = steppingIn("activity_seconds");
}

void keepOutcome(const RunOutcome& outcome) {
  const Json json{{"failure", outcome.failure},
                  {"failure_time", orNull(outcome.failureTime)},
                  {"figures", outcome.figures},
                  {"validation", jsonOf(outcome.validation)},
                  {"steps", outcome.steps},
                  {"fluid_particles", outcome.fluidParticles},
                  {"wall_particles", outcome.wallParticles},
                  {"cost", jsonOf(outcome.cost)}};
  writeTextFile(outcome.folder / outcomeFile, json.dump(2) + "\n");
}

std::optional<RunOutcome> keptOutcome(const std::filesystem::path& folder) {
  const Json json = load(folder / outcomeFile);
  if (!json.is_object()) return std::nullopt;
  try {
    RunOutcome outcome;
    outcome.failure = json.at("failure");
    outcome.failureTime = numberIn(json, "failure_time");
    outcome.figures = figuresIn(json.at("figures"));
    outcome.validation = validatedIn(json.at("validation"));
    outcome.steps = json.at("steps");
    outcome.fluidParticles = json.at("fluid_particles");
    outcome.wallParticles = json.at("wall_particles");
    outcome.cost = costIn(json.at("cost"));
    outcome.folder = folder;
    return outcome;
  } catch (const Json::exception&) {
    return std::nullopt;  // of another version, or damaged: the run is made again
  }
}

HistoryColumn historyOf(const RunOutcome& outcome, const std::string& name) {
  const std::filesystem::path path = outcome.folder / "history.csv";
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw InputError(path.string() + ": cannot be read");
  std::vector<std::string> names = cellsOf(line);
  for (std::string& column : names) column = column.substr(0, column.find(" ["));
  const auto column = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  const auto time = static_cast<std::size_t>(std::ranges::find(names, "time") - names.begin());
  if (column >= names.size())
    throw InputError(fmt::format("{}: has no column {}; it has {}", path.string(), name,
                                 fmt::join(names, ", ")));
  HistoryColumn history;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cellsOf(line);
    if (column >= cells.size() || cells[column].empty()) continue;
    history.times.push_back(std::stod(cells[time]));
    history.values.push_back(std::stod(cells[column]));
  }
  return history;
}

}  // namespace plenum::study
