// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/minimal.hpp"

#include "particles/atomic_file.hpp"
#include "studies/leave_outs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>

namespace plenum::study {

namespace {

/// How often what is close in cost is run before one is called the cheaper.
constexpr int nTimings = 3;

CaseNode rootOf(const RunRequest& request) {
  CaseNode root = CaseNode::load(request.caseFile);
  applyChanges(root, request.quick, request.settings);
  return root;
}

/// Names of files, which are beside the case, from the root folder on: the case may move.
void makeFileNamesAbsolute(const CaseNode& node, const std::filesystem::path& folder,
                           CaseNode& root) {
  if (node.isTable()) {
    for (const auto& [key, child] : node.asTable()) makeFileNamesAbsolute(child, folder, root);
  } else if (node.isArray()) {
    for (const CaseNode& child : node.asArray()) makeFileNamesAbsolute(child, folder, root);
  } else if (node.isString() && !node.asString().empty()) {
    std::error_code none;
    const auto file = std::filesystem::absolute(folder / node.asString());
    if (std::filesystem::is_regular_file(file, none))
      root.set(node.path(), "'" + file.string() + "'");
  }
}

/// What a run of a case is thought to cost: particles, steps and neighbours, in any unit.
double workOf(const CaseSettings& settings) {
  const SolverSettings solver = settings.solverOrDefaults();
  const double spacing = settings.spacing, h = solver.smoothingLength;
  const int d = settings.dimension;
  const double steps = solver.timeStep ? solver.endTime / *solver.timeStep
                                       : solver.endTime / (solver.cfl * h * spacing);
  const double perParticle = 10 + std::pow(2 * h, d);  // work beside that of pairs counts, too
  const double perPair = solver.precision == "double" ? 1.5 : 1;
  return steps * std::pow(spacing, -d) * perParticle * perPair;
}

std::vector<std::string> defaultAxes(const CaseSettings& settings) {
  const double d = settings.spacing;
  return {"kernel=wendland_c2,wendland_c4,convex,cubic_spline,quintic_spline", "h=1.3,1.5,2",
          fmt::format("spacing={},{},{}", 4 * d, 2 * d, d)};
}

/// Candidates of a grid, with families that share all but the spacing.
std::vector<Candidate> candidatesOf(const std::vector<Variation>& axes,
                                    const std::vector<Combination>& grid) {
  std::map<std::vector<std::size_t>, std::size_t> families;
  std::vector<Candidate> candidates;
  for (const Combination& point : grid) {
    std::vector<std::size_t> family = point.at;
    for (std::size_t a = 0; a < axes.size(); ++a)
      if (axes[a].keys.front() == "spacing") family[a] = 0;
    const CaseSettings settings = readCase(rootOf(point.request));
    candidates.push_back({workOf(settings), settings.spacing,
                          families.try_emplace(family, families.size()).first->second});
  }
  return candidates;
}

/// What a case shows of its [[validate]] entries, but not without something, in words; empty: all.
/// What the study measures has its own error to meet.
std::string lossOf(const RunOutcome& without, const RunOutcome& with, const ErrorMeasure& measure) {
  for (std::size_t k = 0; k < std::min(without.validation.size(), with.validation.size()); ++k) {
    const Validated& now = without.validation[k];
    if (now.quantity != measure.quantity && with.validation[k].verdict == "ok" &&
        now.verdict != "ok")
      return fmt::format("but the case no longer shows its {}{}{}", now.quantity,
                         now.statistic.empty() ? "" : ":", now.statistic);
  }
  return "";
}

/// Takes away what is not needed, from `root` on.
class Simplifier {
 public:
  Simplifier(const AccuracyOptions& options, RunStore& store, double error, int threads)
      : options_(options), store_(store), error_(error), threads_(threads) {}

  void operator()(Minimal& minimal) {
    // What is kept once is not tried again: a case without less needs it even more.
    std::size_t next = 0;
    for (std::vector<LeaveOut> left = leaveOutsOf(*minimal.root); next < left.size();) {
      const TriedWithout tried = tryOne(left[next], minimal);
      minimal.without.push_back(tried);
      if (!tried.isLeftOut) {
        ++next;
        continue;
      }
      minimal.root = left[next].root;
      minimal.outcome = tried.outcome;
      minimal.error = tried.error;
      minimal.cost = tried.cost;
      left = leaveOutsOf(*minimal.root);  // without the one that is gone, the others as before
    }
  }

 private:
  /// A run of a case that no file holds yet.
  TriedWithout tryOne(const LeaveOut& without, const Minimal& minimal) {
    TriedWithout tried;
    tried.what = without.what;
    const RunRequest request{options_.folder / "less.toml", {}, threads_, false, 0};
    // Expectations stay as they are: what is left out takes measures away, no [[validate]].
    writeTextFile(request.caseFile, without.root.printedFile(options_.caseFile.filename().string() +
                                                             " without " + without.what));
    tried.failure = RunStore::refusalOf(request);
    if (!tried.failure.empty()) return tried;
    const Study& study = minimal.tried;
    tried.outcome = study.leastOf(store_.repeated(request, nTimings, without.what));
    tried.error = study.measure.of(tried.outcome);
    tried.cost = study.costOf(tried.outcome);
    tried.failure = tried.outcome.failure;
    tried.loss = lossOf(tried.outcome, minimal.outcome, study.measure);
    // Times of a machine that others use scatter by a fifth.
    tried.isLeftOut = tried.error && *tried.error <= error_ &&
                      (tried.loss.empty() || without.isOfScene) && tried.cost <= 1.2 * minimal.cost;
    return tried;
  }

  const AccuracyOptions& options_;
  RunStore& store_;
  double error_;
  int threads_;
};

/// The row of the least cost within `error`. Those whose first time was not half as long again as
/// the least are timed again: one time each, on a machine that others use, does not tell them
/// apart.
std::size_t cheapestOf(Minimal& minimal, const std::vector<std::size_t>& tried,
                       const std::vector<Combination>& grid, double error, RunStore& store) {
  Study& study = minimal.tried;
  std::vector<StudyRow>& rows = study.rows;
  const auto isWithin = [&](std::size_t r) { return rows[r].error && *rows[r].error <= error; };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (isWithin(r)) least = std::min(least, study.costOf(rows[r]));
  std::size_t found = rows.size();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (!isWithin(r) || study.costOf(rows[r]) > 1.5 * least) continue;
    rows[r].outcome = study.leastOf(store.repeated(grid[tried[r]].request, nTimings, rows[r].name));
    minimal.searchCost += (nTimings - 1) * study.costOf(rows[r]);
    if (found == rows.size() || study.costOf(rows[r]) < study.costOf(rows[found])) found = r;
  }
  return found;
}

}  // namespace

Minimal findMinimal(const AccuracyOptions& options, double error) {
  Minimal minimal;
  Study& study = minimal.tried;
  const RunRequest base{options.caseFile, options.settings, 1, options.quick};
  study.caseFile = options.caseFile;
  study.settings = readCase(rootOf(base));
  for (const std::string& text : options.vary.empty() ? defaultAxes(study.settings) : options.vary)
    study.axes.push_back(Variation::parse(text, options.caseFile));
  std::vector<Combination> grid = gridOf(study.axes, base);
  std::vector<RunRequest> requests;
  for (const Combination& point : grid) requests.push_back(point.request);
  if (options.vary.empty())
    std::erase_if(
        grid, [](const Combination& point) { return !RunStore::refusalOf(point.request).empty(); });
  if (!options.vary.empty() || grid.empty()) RunStore::requireUsable(requests);
  minimal.nOfGrid = grid.size();
  RunStore store(options.folder / "runs", Programs::find(options.programs), true);
  study.measure = measureFor(options, study.settings, store);

  const auto run = [&](std::size_t k) -> std::optional<CostAndError> {
    const std::string name = describe(study.axes, grid[k].at);
    const RunOutcome outcome = store.run({grid[k].request}, 1, name).front();
    study.rows.push_back({grid[k].at, name, outcome, study.measure.of(outcome)});
    const StudyRow& row = study.rows.back();
    study.unit = unitOf(study);
    minimal.searchCost += study.costOf(row);
    if (!options.quiet)
      std::cerr << fmt::format(
          "{:3} of at most {}: {}: {}\n", study.rows.size(), grid.size(), name,
          row.error ? study.printed(*row.error) : "failed: " + row.outcome.failure);
    return row.error ? std::optional(CostAndError{study.costOf(row), *row.error}) : std::nullopt;
  };
  const Search search = findCheapest(candidatesOf(study.axes, grid), error, run);
  if (!search.found) return minimal;
  minimal.found = cheapestOf(minimal, search.tried, grid, error, store);
  const StudyRow& row = study.rows[*minimal.found];
  const CaseNode found = rootOf(grid[search.tried[*minimal.found]].request);
  minimal.root = found;
  makeFileNamesAbsolute(found, options.caseFile.parent_path(), *minimal.root);
  minimal.outcome = row.outcome;
  minimal.error = row.error;
  minimal.cost = study.costOf(row);
  Simplifier(options, store, error, grid[search.tried[*minimal.found]].request.threads)(minimal);
  return minimal;
}

std::vector<std::string> sentencesOf(const Minimal& minimal, double error) {
  const Study& study = minimal.tried;
  if (!minimal.found) {
    std::vector<std::string> sentences = adviceOf(study, {error});
    sentences.push_back(
        fmt::format("{} of {} settings were run; by the order of convergence that they show, or by "
                    "second order where one spacing shows none, the others do not reach it.",
                    study.rows.size(), minimal.nOfGrid));
    return sentences;
  }
  const StudyRow& row = study.rows[*minimal.found];
  std::vector<std::string> sentences{fmt::format(
      "The cheapest setting within {}: {}: {}, {:.3g} s. {} of {} settings were run, {:.3g} s.",
      study.printed(error), row.name, study.printed(*row.error), study.costOf(row),
      study.rows.size(), minimal.nOfGrid, minimal.searchCost)};
  for (const TriedWithout& tried : minimal.without)
    sentences.push_back(tried.error
                            ? fmt::format("Without {}: {}, {:.3g} s{}{}: {}.", tried.what,
                                          study.printed(*tried.error), tried.cost,
                                          tried.loss.empty() ? "" : ", ", tried.loss,
                                          tried.isLeftOut ? "left out" : "kept")
                            : fmt::format("Without {}: {}: kept.", tried.what,
                                          tried.failure.empty() ? "no value" : tried.failure));
  return sentences;
}

}  // namespace plenum::study
