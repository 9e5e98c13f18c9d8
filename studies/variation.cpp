// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/variation.hpp"

#include "particles/case_settings.hpp"
#include "particles/errors.hpp"
#include "studies/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>

namespace plenum::study {

std::vector<std::string> splitOutsideBrackets(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else {
      depth += (c == '{' || c == '[') - (c == '}' || c == ']');
      if (c == separator && depth == 0) {
        parts.emplace_back();
        continue;
      }
    }
    parts.back() += c;
  }
  return parts;
}

namespace {

constexpr const char *threadsKey = "threads", *factorKey = "time_step_factor";

std::vector<std::string> keysOf(const SectionDoc& section) {
  std::vector<std::string> keys;
  for (const ParameterDoc& parameter : section.parameters) keys.push_back(parameter.key);
  for (const SectionDoc& inner : section.inner) keys.push_back(inner.key);
  return keys;
}

/// Short names that stand for other keys, or for no key of a case.
const std::vector<std::pair<std::string, std::string>> shortNames{{"h", "solver.smoothing_length"},
                                                                  {"walls", "solver.wall_pressure"},
                                                                  {"relaxation", "relax"},
                                                                  {threadsKey, threadsKey},
                                                                  {factorKey, factorKey}};

/// The keys of a case that the name on a command line stands for.
std::vector<std::string> keysNamed(const std::string& name, const CaseNode& root) {
  for (const auto& [shorter, key] : shortNames)
    if (shorter == name) return {key};
  if (name == "lattice") {
    std::vector<std::string> keys;
    const CaseNode* fluids = root.find("fluid");
    const std::size_t n = fluids != nullptr && fluids->isArray() ? fluids->asArray().size() : 0;
    for (std::size_t k = 0; k < n; ++k) keys.push_back(fmt::format("fluid[{}].lattice", k));
    return keys;
  }
  if (name.find_first_of(".[") != std::string::npos) return {name};
  const std::vector<std::string> ofSolver = keysOf(solverSection().doc("solver"));
  if (std::ranges::count(ofSolver, name) > 0) return {"solver." + name};
  std::vector<std::string> known = keysOf(caseSection().doc(""));
  if (std::ranges::count(known, name) > 0) return {name};
  known.insert(known.end(), ofSolver.begin(), ofSolver.end());
  for (const auto& [shorter, key] : shortNames) known.push_back(shorter);
  known.push_back("lattice");
  std::ranges::sort(known);
  const auto twice = std::ranges::unique(known);
  known.erase(twice.begin(), twice.end());
  const std::string guess = nearest(name, known);
  throw InputError(fmt::format(
      "--vary {}: there is no such setting{}; there are {}, and every key "
      "of a case in full, as fluid[0].seed",
      name, guess.empty() ? "" : fmt::format(", did you mean {}?", guess), fmt::join(known, ", ")));
}

/// What a case has at a key that may be absent.
std::optional<double> numberAt(const CaseNode& root, const char* table, const char* key) {
  const CaseNode* in = *table == 0 ? &root : root.find(table);
  const CaseNode* node = in != nullptr && in->isTable() ? in->find(key) : nullptr;
  return node != nullptr && node->isNumber() ? std::optional(node->asNumber()) : std::nullopt;
}

bool names(const std::vector<std::string>& settings, const std::string& key) {
  return std::ranges::any_of(settings, [&](const std::string& s) { return s.starts_with(key); });
}

bool areSame(const std::string& a, const std::string& b) {
  const auto number = numberIn(a);
  return a == b || (number && number == numberIn(b));
}

/// Threads that share a core would say nothing of either.
int threadsOf(double number) {
  const unsigned nCores = std::max(1u, std::thread::hardware_concurrency());
  if (number > nCores)
    throw InputError(fmt::format("--vary threads: {:g} are more than the {} core{} of this machine",
                                 number, nCores, nCores == 1 ? "" : "s"));
  return static_cast<int>(number);
}

/// The case's own step, as far as spacing and factor change it.
void setTimeStep(const RunRequest& base, double factor, bool variesSpacing, RunRequest& request) {
  CaseNode before = CaseNode::load(base.caseFile), after = before;
  applyChanges(before, base.quick, base.settings);
  applyChanges(after, base.quick, request.settings);
  if (const auto step = numberAt(after, "solver", "time_step")) {
    const bool isSet = names(base.settings, "solver.time_step=") ||
                       *step != numberAt(before, "solver", "time_step");
    const auto spacing = numberAt(after, "", "spacing"), first = numberAt(before, "", "spacing");
    if (variesSpacing && !isSet && spacing && first) factor *= *spacing / *first;
    if (factor != 1) request.settings.push_back(fmt::format("solver.time_step={}", *step * factor));
  } else if (factor != 1) {
    const double cfl = numberAt(after, "solver", "cfl").value_or(SolverSettings{}.cfl);
    request.settings.push_back(fmt::format("solver.cfl={}", cfl * factor));
  }
}

}  // namespace

Variation Variation::parse(const std::string& text, const std::filesystem::path& caseFile) {
  const CaseNode root = CaseNode::load(caseFile);
  if (text.find('=') == std::string::npos || text.starts_with('='))
    throw InputError(fmt::format("--vary {}: no setting; write KEY=VALUE,VALUE", text));
  const auto [left, right] = CaseNode::splitAssignment(text);
  Variation axis;
  const std::vector<std::string> given = splitOutsideBrackets(left, ':');
  axis.names = given;
  axis.places.clear();
  std::vector<std::size_t> wide;  // keys that each name stands for
  for (const std::string& name : given) {
    const std::vector<std::string> keys = keysNamed(name, root);
    axis.places.push_back(axis.keys.size());
    wide.push_back(keys.size());
    axis.keys.insert(axis.keys.end(), keys.begin(), keys.end());
  }
  for (const std::string& value : splitOutsideBrackets(right, ',')) {
    const std::vector<std::string> tied = splitOutsideBrackets(value, ':');
    if (tied.size() != given.size() || std::ranges::count(tied, "") > 0)
      throw InputError(
          fmt::format("--vary {}: '{}' has {} values for {}; write --vary "
                      "KEY=VALUE,VALUE or KEY:KEY=VALUE:VALUE,VALUE:VALUE",
                      text, value, value.empty() ? 0 : tied.size(), fmt::join(given, ":")));
    axis.values.emplace_back();
    for (std::size_t k = 0; k < given.size(); ++k)
      axis.values.back().insert(axis.values.back().end(), wide[k], tied[k]);
    const auto isSame = [&](const auto& other) {
      return std::ranges::equal(other, axis.values.back(), areSame);
    };
    if (std::ranges::count_if(axis.values, isSame) > 1)
      throw InputError(fmt::format("--vary {}: {} stands there twice", text, value));
  }
  return axis;
}

namespace {

void requireDistinctKeys(const std::vector<Variation>& axes,
                         const std::vector<std::string>& settings) {
  std::vector<std::string> known;
  for (const Variation& axis : axes)
    for (const std::string& key : axis.keys) {
      if (std::ranges::count(known, key) > 0)
        throw InputError(
            fmt::format("--vary: {} is varied twice; write all its values behind one "
                        "--vary, with commas between",
                        key));
      if (names(settings, key + "="))
        throw InputError(fmt::format("--vary: {} is given by --set, too; name it in one", key));
      known.push_back(key);
    }
}

}  // namespace

std::vector<Combination> gridOf(const std::vector<Variation>& axes, const RunRequest& base) {
  requireDistinctKeys(axes, base.settings);
  std::vector<Combination> grid;
  std::vector<std::size_t> at(axes.size(), 0);
  for (;;) {
    Combination point{at, base};
    double factor = 1;
    bool variesSpacing = false;
    for (std::size_t a = 0; a < axes.size(); ++a)
      for (std::size_t k = 0; k < axes[a].keys.size(); ++k) {
        const std::string &key = axes[a].keys[k], &value = axes[a].values[at[a]][k];
        if (value == "case") continue;
        if (key == threadsKey || key == factorKey) {
          const std::optional<double> number = numberIn(value);
          if (!number || *number <= 0 || (key == threadsKey && *number != std::floor(*number)))
            throw InputError(fmt::format("--vary {}: '{}' is no positive {}", key, value,
                                         key == threadsKey ? "whole number" : "number"));
          if (key == threadsKey) point.request.threads = threadsOf(*number);
          if (key == factorKey) factor = *number;
        } else {
          variesSpacing |= key == "spacing";
          point.request.settings.push_back(key + "=" + value);
        }
      }
    if (factor != 1 || (variesSpacing && !names(point.request.settings, "solver.time_step=")))
      setTimeStep(base, factor, variesSpacing, point.request);
    grid.push_back(std::move(point));
    std::size_t a = axes.size();
    while (a > 0 && ++at[a - 1] == axes[a - 1].values.size()) at[--a] = 0;
    if (a == 0) return grid;
  }
}

bool Variation::isOfThreads() const { return std::ranges::count(keys, threadsKey) > 0; }

std::string Variation::name() const { return fmt::format("{}", fmt::join(names, ":")); }

std::string Variation::textOf(std::size_t value) const {
  std::vector<std::string> texts;
  for (std::size_t n = 0; n < names.size(); ++n) texts.push_back(textOf(value, n));
  return fmt::format("{}", fmt::join(texts, ":"));
}

namespace {

std::string describeOne(const std::string& name, const std::string& value) {
  if (value == "case") return name + " as in the case";
  if (numberIn(value) && (name == "h" || name == "smoothing_length"))
    return fmt::format("h = {} d_ref", value);
  return numberIn(value) || value.starts_with('{') ? fmt::format("{} {}", name, value) : value;
}

}  // namespace

std::string describe(const std::vector<Variation>& axes, const std::vector<std::size_t>& at) {
  if (axes.empty()) return "as the case has it";
  std::vector<std::string> parts;
  for (std::size_t a = 0; a < axes.size(); ++a)
    for (std::size_t n = 0; n < axes[a].names.size(); ++n)
      parts.push_back(describeOne(axes[a].names[n], axes[a].textOf(at[a], n)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace plenum::study
