// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/table.hpp"

#include "engine/instruction_set.hpp"
#include "engine/stopwatch.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace plenum::bench {

namespace {

using Run = benchmark::BenchmarkReporter::Run;

/// The words of a name: scene, dimension, precision, n and threads.
struct Row {
  std::string scene, dimension, precision;
  long n = 0;
  int threads = 0;
  Runs runs;
};

std::vector<Row> rowsOf(const Runs& runs) {
  std::map<std::tuple<std::string, std::string, long, std::string, int>, Row> rows;
  for (const Run& run : runs) {
    if (!run.counters.contains(counter::perInteraction)) continue;
    const std::string name = run.benchmark_name();
    Row row;
    std::size_t at = 0;
    const auto word = [&] {
      const std::size_t end = std::min(name.find('/', at), name.size());
      const std::string text = name.substr(at, end - at);
      at = end + 1;
      return text;
    };
    row.scene = word();
    row.dimension = word();
    row.precision = word();
    row.n = std::stol(word().substr(2));
    row.threads = static_cast<int>(run.counters.at(counter::threads));
    Row& known =
        rows[{row.scene, row.dimension, row.n, row.precision == "mixed" ? "a" : "b", row.threads}];
    if (known.runs.empty()) known = row;
    known.runs.push_back(run);
  }
  std::vector<Row> inOrder;
  for (auto& [key, row] : rows) inOrder.push_back(std::move(row));
  return inOrder;
}

std::string heading() {
  return fmt::format("{:<48} | {:>16} | {:^13} | {:>5} | {:^29} | {:>4} | {:^14}\n", "",
                     "ns/interaction", "M particles/s", "steps", "share of a step [%]", "% of",
                     "bytes/particle") +
         fmt::format(
             "{:<9} {:<3} {:<6} {:>3} {:>5} {:>8} {:>8}  | {:>7} {:>8} | {:>6} {:>6} |"
             " {:>5} | {:>5} {:>5} {:>5} {:>5} {:>5} | {:>4} | {:>6} {:>7}\n",
             "scene", "dim", "pairs", "thr", "cores", "fluid", "walls", "median", "+- %", "all",
             "fluid", "/sort", "sort", "srch", "load", "pairs", "integ", "peak", "counted",
             "process");
}

/// Whether other programs took the cores that the threads of a case would have used.
bool wasDisturbed(const Row& row) {
  return row.threads > 1 && median(row.runs, counter::coresUsed) < leastShareOfCores * row.threads;
}

std::string line(const Row& row) {
  const auto get = [&](const char* name) { return median(row.runs, name); };
  const double bytes = get(counter::processBytes);
  std::string text = fmt::format(
      "{:<9} {:<3} {:<6} {:>3} {:>5.2f} {:>8.0f} {:>8.0f}{} | {:>7.3f}{} {:>7.0f} | {:>6.2f} "
      "{:>6.2f} | {:>5.0f} |",
      row.scene, row.dimension, row.precision, row.threads, get(counter::coresUsed),
      get(counter::nFluid), get(counter::nWalls),
      row.runs.front().report_label == "made" ? "*" : " ", get(counter::perInteraction),
      wasDisturbed(row) ? "!" : " ", 0.5 * spreadPercent(row.runs, counter::perInteraction),
      get(counter::millions), get(counter::fluidMillions), get(counter::stepsPerRebuild));
  for (const std::string_view part : partNames)
    text += fmt::format(" {:>5.1f}", get(std::string(part).c_str()));
  text += fmt::format(" | {:>4.0f} | {:>6.0f} {:>7}\n", get(counter::ofPeak),
                      get(counter::countedBytes),
                      row.n >= 1000000 && bytes > 0 ? fmt::format("{:.0f}", bytes) : "-");
  return text;
}

std::string peakLine(const Runs& runs) {
  std::map<std::pair<std::string, int>, Runs> peaks;
  for (const Run& run : runs) {
    const std::string name = run.benchmark_name();
    if (!name.starts_with("fma_peak/")) continue;
    const std::string precision = name.find("/mixed/") != std::string::npos ? "float" : "double";
    peaks[{precision, static_cast<int>(run.counters.at(counter::threads))}].push_back(run);
  }
  std::string text =
      fmt::format("instruction set {}; multiply-adds alone reach", nameOf(instructionSet()));
  for (const auto& [key, group] : peaks)
    text += fmt::format("{} {:.0f} Gflop/s in {} with {} thread{} (+- {:.0f} %)",
                        key == peaks.begin()->first ? "" : ",", median(group, counter::peak),
                        key.first, key.second, key.second == 1 ? "" : "s",
                        0.5 * spreadPercent(group, counter::peak));
  return text + '\n';
}

}  // namespace

std::string tableOf(const Runs& runs) {
  std::string text = peakLine(runs) + heading();
  std::string scene;
  bool anyMade = false, anyDisturbed = false;
  for (const Row& row : rowsOf(runs)) {
    if (!scene.empty() && scene != row.scene + row.dimension) text += '\n';
    scene = row.scene + row.dimension;
    anyMade |= row.runs.front().report_label == "made";
    anyDisturbed |= wasDisturbed(row);
    text += line(row);
  }
  if (anyMade) text += "* made to look like a running dam break; the others were run from rest\n";
  if (anyDisturbed)
    text += fmt::format(
        "! other programs took more than {:.0f} % of the cores: this wall time says little\n",
        100 * (1 - leastShareOfCores));
  return text;
}

}  // namespace plenum::bench
