// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/suite.hpp"

#include "bench/flops.hpp"
#include "bench/peak.hpp"
#include "bench/running_state.hpp"
#include "bench/step_probe.hpp"
#include "bench/worker.hpp"
#include "particles/errors.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <regex>

namespace plenum::bench {

namespace {

using Run = benchmark::BenchmarkReporter::Run;
using StepWorker = Worker<Request, Measurement>;
struct PeakRequest {
  bool inDouble;
  int threads;
};
using PeakWorker = Worker<PeakRequest, double>;

/// From here on a measurement may end before the next search, and repetitions are fewer.
constexpr std::size_t large = 1000000;
/// Larger cases run one after the other: several would not fit into memory.
constexpr std::size_t mostTogether = 1000000;

/// Keeps what was measured; it is shown when all is done.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::vector<Run>& runs) : runs_(runs) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration) runs_.push_back(run);
  }

 private:
  std::vector<Run>& runs_;
};

void setCounters(benchmark::UserCounters& counters, const Case& c, int threads,
                 const Measurement& m) {
  const Flops flops = c.isDamBreak()   ? damBreakFlops(c.dimension)
                      : c.isIdealGas() ? idealGasFlops(c.dimension)
                                       : quietGasFlops(c.dimension);
  const double work = m.interactions.all * flops.density + m.interactions.ofFluids * flops.forces;
  // The share of the pair loops is known by the wall clock.
  const double pairShare = m.partSeconds[static_cast<int>(Part::pairs)] / m.wallSeconds;
  counters[counter::dimension] = c.dimension;
  counters[counter::threads] = threads;
  counters[counter::n] = m.n();
  counters[counter::nFluid] = m.nFluid;
  counters[counter::nWalls] = m.nWalls;
  counters[counter::isRunning] = m.isRunning;
  counters[counter::perInteraction] = m.seconds / m.interactions.all * 1e9;
  counters[counter::perParticle] = m.seconds / m.n() * 1e9;
  counters[counter::interactions] = m.interactions.all / m.n();
  counters[counter::millions] = m.n() / m.seconds * 1e-6;
  counters[counter::fluidMillions] = m.nFluid / m.seconds * 1e-6;
  counters[counter::stepsPerRebuild] = m.stepsPerRebuild;
  for (int k = 0; k < static_cast<int>(Part::count); ++k)
    counters[std::string(partNames[static_cast<std::size_t>(k)])] =
        100 * m.partSeconds[k] / m.wallSeconds;
  counters[counter::gflops] = work / (pairShare * m.seconds) * 1e-9;
  counters[counter::coresUsed] = m.cpuSeconds / m.wallSeconds;
  counters[counter::countedBytes] = m.countedBytes;
  if (m.processBytes > 0) counters[counter::processBytes] = m.processBytes;
}

/// Calls measure(); what it throws is an error of the benchmark.
template <class Measure>
void guarded(benchmark::State& state, Measure&& measure) {
  try {
    measure();
  } catch (const std::exception& error) {
    state.SkipWithError(error.what());
  }
}

void addStep(const std::shared_ptr<StepWorker>& worker, const Case& c, const Request& request,
             int repetitions) {
  benchmark::RegisterBenchmark(
      fmt::format("{}/threads:{}", c.name(), request.threads).c_str(),
      [=](benchmark::State& state) {
        guarded(state, [&] {
          const Measurement m = worker->ask(request);
          for (auto _ : state) state.SetIterationTime(m.seconds);
          setCounters(state.counters, c, request.threads, m);
          state.SetLabel(c.isDamBreak() ? (m.isRunning ? "running" : "made") : "");
        });
      })
      ->Iterations(1)
      ->UseManualTime()
      ->Repetitions(repetitions)
      ->Unit(benchmark::kMillisecond);
}

std::string peakName(const std::string& precision, int threads, std::size_t n) {
  return fmt::format("fma_peak/{}/beside_n:{}/threads:{}", precision, n, threads);
}

void addPeak(const std::shared_ptr<PeakWorker>& worker, const std::string& precision, int threads,
             std::size_t n, int repetitions) {
  benchmark::RegisterBenchmark(
      peakName(precision, threads, n).c_str(),
      [=](benchmark::State& state) {
        guarded(state, [&] {
          const double gflops = worker->ask({precision == "double", threads});
          for (auto _ : state) state.SetIterationTime(1e-9 / gflops);  // of one operation
          state.counters[counter::peak] = gflops;
          state.counters[counter::threads] = threads;
        });
      })
      ->Iterations(1)
      ->UseManualTime()
      ->Repetitions(repetitions)
      ->Unit(benchmark::kNanosecond);
}

/// The running dam breaks that the cases begin from are made one at a time, by all cores.
void makeRunningStates(const std::vector<Case>& cases, const Choice& choice) {
  for (const Case& c : cases) {
    if (!isReallyRun(c, choice)) continue;
    Worker<char, char> maker(c.name(), [&]() -> Worker<char, char>::Serve {
      if (c.dimension == 2)
        damBreakRunning<2>(c.n, choice.states);
      else
        damBreakRunning<3>(c.n, choice.states);
      return [](char request) { return request; };
    });
    maker.ask(0);
  }
}

std::string baseName(const Run& run) {
  const std::string name = run.benchmark_name();
  return name.substr(0, name.find("/iterations:"));
}

}  // namespace

double median(const Runs& runs, const char* counter) {
  std::vector<double> values;
  for (const Run& run : runs)
    if (const auto found = run.counters.find(counter); found != run.counters.end())
      values.push_back(found->second);
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double spreadPercent(const Runs& runs, const char* counter) {
  double least = runs.front().counters.at(counter), most = least;
  for (const Run& run : runs) {
    least = std::min<double>(least, run.counters.at(counter));
    most = std::max<double>(most, run.counters.at(counter));
  }
  return 100 * (most - least) / median(runs, counter);
}

Suite::Suite(const Choice& choice) : choice_(choice) {
  // Google Benchmark reads its own options from a command line only, and keeps the first word.
  static std::string words[] = {"plenum-bench", "--benchmark_enable_random_interleaving=true"};
  char* arguments[] = {words[0].data(), words[1].data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, arguments);
  benchmark::AddCustomContext("instruction_set", std::string(nameOf(instructionSet())));
}

void Suite::run() {
  const std::regex filter(choice_.filter);
  for (const std::vector<Case>& size : casesOf(choice_)) {
    std::vector<Case> chosen;
    std::ranges::copy_if(size, std::back_inserter(chosen),
                         [&](const Case& c) { return std::regex_search(c.name(), filter); });
    if (chosen.empty()) continue;
    makeRunningStates(chosen, choice_);
    if (chosen.front().n <= mostTogether)
      runTogether(chosen);
    else
      for (const Case& c : chosen) runTogether({c});
  }
  if (runs_.empty())
    throw InputError(
        fmt::format("--filter {}: matches no case; names look like dam_break/2d/mixed/n:100000",
                    choice_.filter));
}

/// Measures cases that take turns, and the peak with them.
void Suite::runTogether(const std::vector<Case>& cases) {
  const std::size_t n = cases.front().n;
  const int repetitions = choice_.repetitions > 0 ? choice_.repetitions : n >= large ? 3 : 5;
  std::fprintf(stderr, "%zu particles ...\n", n);
  benchmark::ClearRegisteredBenchmarks();
  const auto peakWorker = std::make_shared<PeakWorker>("fma_peak", []() -> PeakWorker::Serve {
    return [](const PeakRequest& r) { return peakGflops(r.inDouble, r.threads); };
  });
  for (const int threads : choice_.threads) {
    for (const char* precision : {"mixed", "double"})
      addPeak(peakWorker, precision, threads, n, repetitions);
  }
  for (const Case& c : cases) {
    const auto worker =
        std::make_shared<StepWorker>(c.name(), [&] { return stepProbe(c, choice_); });
    for (const int threads : choice_.threads)
      addStep(worker, c, {threads, choice_.seconds, 4 * choice_.seconds}, repetitions);
  }
  std::vector<Run> runs;
  Collector collector(runs);
  benchmark::RunSpecifiedBenchmarks(&collector, ".");
  benchmark::ClearRegisteredBenchmarks();
  std::map<std::string, Runs> byName;
  for (const Run& run : runs) {
    if (run.error_occurred) throw RunError(run.error_message);
    byName[baseName(run)].push_back(run);
  }
  for (const Case& c : cases)
    for (const int threads : choice_.threads) {
      Runs& mine = byName.at(fmt::format("{}/threads:{}", c.name(), threads));
      const double peak = median(byName.at(peakName(c.precision, threads, n)), counter::peak);
      for (Run& run : mine) {
        run.counters[counter::peak] = peak;
        run.counters[counter::ofPeak] = 100 * run.counters[counter::gflops] / peak;
      }
    }
  for (auto& [name, group] : byName) runs_.insert(runs_.end(), group.begin(), group.end());
}

void Suite::writeJson(const std::string& path) const {
  std::ofstream file(path);
  benchmark::JSONReporter reporter;
  reporter.SetOutputStream(&file);
  reporter.SetErrorStream(&file);
  reporter.ReportContext(benchmark::BenchmarkReporter::Context());
  reporter.ReportRuns(runs_);
  reporter.Finalize();
  file.close();
  if (!file) throw RunError(fmt::format("{}: cannot be written; is there such a folder?", path));
}

}  // namespace plenum::bench
