// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/run_store.hpp"

#include "ictools/check.hpp"
#include "particles/case_settings.hpp"
#include "particles/errors.hpp"
#include "particles/progress.hpp"
#include "studies/key.hpp"
#include "studies/process.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <map>
#include <mutex>
#include <regex>
#include <sstream>

namespace plenum::study {

namespace fs = std::filesystem;

namespace {

/// Adds the files that the values of a case name, as its geometry and its tables do.
void addFilesOf(const CaseNode& node, const fs::path& folder, Key& key) {
  if (node.isString()) {
    std::error_code none;
    const fs::path named = folder / node.asString();
    if (!node.asString().empty() && fs::is_regular_file(named, none)) key.addFile(named);
  } else if (node.isArray()) {
    for (const CaseNode& child : node.asArray()) addFilesOf(child, folder, key);
  } else if (node.isTable()) {
    for (const auto& [name, child] : node.asTable()) addFilesOf(child, folder, key);
  }
}

/// The first line of a program's message that is no warning, without the program's name.
std::string errorIn(const std::string& errors) {
  std::istringstream lines(errors);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.find(": warning: ") != std::string::npos) continue;
    for (const std::string_view name : {"plenum-sph: ", "plenum-ic: "})
      if (line.starts_with(name)) return line.substr(name.size());
    return line;
  }
  return "";
}

std::string reasonOf(const ProcessEnd& end) {
  if (end.signal != 0)
    return fmt::format("ended by signal {} ({}){}", end.signal, strsignal(end.signal),
                       end.signal == SIGKILL ? ": likely out of memory" : "");
  const std::string said = errorIn(end.errors);
  return said.empty() ? fmt::format("exit code {}", end.exitCode) : said;
}

/// Whether a program ended for what no setting is to blame for: a full disk, a file that cannot be
/// written, a program that is not there.
bool isOfTheMachine(const ProcessEnd& end) {
  return end.exitCode == 127 || end.exitCode == 126 || end.signal == SIGXFSZ ||
         end.errors.find("cannot be written") != std::string::npos ||
         end.errors.find("cannot be made") != std::string::npos;
}

/// The time that a message of plenum-sph names [s].
std::optional<double> timeIn(const std::string& message) {
  static const std::regex time(R"(t = ([-+0-9.e]+) s)");
  std::smatch found;
  if (!std::regex_search(message, found, time)) return std::nullopt;
  return std::stod(found[1]);
}

/// What a series is to be looked at with; a study looks at histories and last pictures.
void removeSeries(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path ending = entry.path().extension();
    if (ending == ".vtu" || ending == ".pvd") fs::remove(entry.path());
  }
}

std::string described(const RunRequest& request) {
  return request.settings.empty() ? request.caseFile.string()
                                  : fmt::format("{}", fmt::join(request.settings, " "));
}

}  // namespace

RunStore::RunStore(fs::path folder, Programs programs, bool quiet)
    : lock_(folder), folder_(std::move(folder)), programs_(std::move(programs)), quiet_(quiet) {}

fs::path RunStore::folderOf(const RunRequest& request) const {
  CaseNode root = CaseNode::load(request.caseFile);
  applyChanges(root, request.quick, request.settings);
  Key key;
  key.add(root.printedFile(""));
  addFilesOf(root, request.caseFile.parent_path(), key);
  key.add(std::to_string(request.threads));
  if (request.repeat > 0) key.add(fmt::format("again {}", request.repeat));
  key.add(programs_.fingerprint);
  return folder_ / key.text();
}

std::string RunStore::refusalOf(const RunRequest& request) {
  const CheckReport report = checkCase(request.caseFile, request.settings, request.quick);
  for (const Finding& finding : report.findings.all())
    if (finding.severity == Severity::error) return finding.text();
  return "";
}

void RunStore::requireUsable(const std::vector<RunRequest>& requests) {
  std::vector<std::string> refused;
  for (const RunRequest& request : requests) {
    const CheckReport report = checkCase(request.caseFile, request.settings, request.quick);
    for (const Finding& finding : report.findings.all())
      if (finding.severity == Severity::error)
        refused.push_back(fmt::format("{}: {}", described(request), finding.text()));
  }
  if (refused.empty()) return;
  throw InputError(
      fmt::format("nothing was run, because {} of the settings asked for cannot be "
                  "used:\n  {}",
                  refused.size(), fmt::join(refused, "\n  ")));
}

RunOutcome RunStore::make(const RunRequest& request, const fs::path& folder) const {
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string particles = (folder / "run.hdf").string();
  std::vector<std::string> generate{programs_.ic,  "generate", request.caseFile, "-q",
                                    "--no-report", "-o",       particles};
  if (request.quick) generate.push_back("--quick");
  for (const std::string& setting : request.settings) {
    generate.push_back("--set");
    generate.push_back(setting);
  }
  RunOutcome outcome;
  outcome.folder = folder;
  ProcessEnd end = runProcess(generate);
  if (end.isDone()) {
    end = runProcess({programs_.sph, "run", particles, "-q", "--anew", "-j",
                      std::to_string(request.threads), "-o", folder});
    outcome.cost.cpuSeconds = end.cpuSeconds;
    outcome.cost.wallSeconds = end.wallSeconds;
    outcome.cost.instructions = end.instructions;
    outcome.cost.peakBytes = end.peakBytes;
    readResults(folder, outcome);
  }
  if (!end.isDone()) {
    outcome.failure = reasonOf(end);
    outcome.failureTime = timeIn(outcome.failure);
  }
  removeSeries(folder);
  // A run that somebody stopped is none.
  if (end.signal == SIGINT || end.signal == SIGTERM || end.exitCode == 128 + SIGINT ||
      end.exitCode == 128 + SIGTERM)
    throw RunError(fmt::format("{}: {}; the study goes on from here when it is begun again",
                               described(request), outcome.failure));
  if (isOfTheMachine(end))
    throw RunError(fmt::format("{}: {}; the study goes on from here when it is begun again",
                               described(request), outcome.failure));
  if (programs_.haveChanged() || folderOf(request) != folder)
    throw RunError(
        fmt::format("{}: the case, or a program, has changed since the study began; "
                    "begin the study again, which makes what has changed anew",
                    request.caseFile.string()));
  // One that the system killed, for memory, has a chance when the study is begun again.
  if (end.signal != SIGKILL) keepOutcome(outcome);
  return outcome;
}

std::vector<RunOutcome> RunStore::run(const std::vector<RunRequest>& requests, int jobs,
                                      const std::string& label) {
  std::vector<fs::path> folders;
  std::vector<std::optional<RunOutcome>> outcomes;
  std::vector<std::size_t> toMake;
  std::vector<RunRequest> requestsToMake;
  std::map<fs::path, std::size_t> firstOf;  // requests of the same run
  for (std::size_t k = 0; k < requests.size(); ++k) {
    folders.push_back(folderOf(requests[k]));
    outcomes.push_back(keptOutcome(folders[k]));
    if (!firstOf.try_emplace(folders[k], k).second || outcomes[k]) continue;
    toMake.push_back(k);
    requestsToMake.push_back(requests[k]);
  }
  requireUsable(requestsToMake);
  Progress progress(label, static_cast<double>(toMake.size()), quiet_ || toMake.empty());
  std::mutex guard;
  int nDone = 0;
  inParallel(toMake.size(), jobs, [&](std::size_t at) {
    const std::size_t k = toMake[at];
    RunOutcome outcome = make(requests[k], folders[k]);
    const std::lock_guard lock(guard);
    progress.update(++nDone, described(requests[k]) + (outcome.hasFailed() ? ": failed" : ""));
    outcomes[k] = std::move(outcome);
  });
  if (!toMake.empty()) progress.finish();
  std::vector<RunOutcome> all;
  for (std::size_t k = 0; k < requests.size(); ++k)
    all.push_back(outcomes[firstOf.at(folders[k])].value());
  return all;
}

std::vector<RunOutcome> RunStore::repeated(RunRequest request, int nTimes,
                                           const std::string& label) {
  std::vector<RunRequest> requests;
  for (request.repeat = 0; request.repeat < nTimes; ++request.repeat) requests.push_back(request);
  return run(requests, 1, label);
}

}  // namespace plenum::study
