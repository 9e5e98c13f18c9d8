// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run.hpp"

#include "particles/errors.hpp"
#include "particles/progress.hpp"
#include "particles/version.hpp"
#include "solver/checkpoints.hpp"
#include "solver/interactions.hpp"
#include "solver/recorder.hpp"
#include "solver/schedule.hpp"
#include "solver/state_row.hpp"
#include "solver/stop_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>

namespace plenum {

namespace {

/// A run from its first state, or from where it stopped, to its end.
template <int Dim>
class Run {
 public:
  Run(Scene<Dim> scene, const CaseSettings& settings, const RunOptions& options)
      : settings_(settings),
        options_(options),
        solver_(settings.solverOrDefaults()),
        output_(settings.outputOrDefaults()),
        simulation_(std::move(scene), solver_, settings.measuresOrDefaults().loads),
        observers_(settings.measuresOrDefaults(), observed(simulation_)),
        states_(simulation_.runStart(), output_.every, solver_.endTime),
        rows_(simulation_.runStart(), output_.historyEvery.value_or(output_.every), solver_.endTime,
              Validation::timesOf(settings.validations)),
        checkpoints_(options.folder, options.name, output_.checkpointsKept) {
    if (output_.checkpointEvery)
      pauses_.emplace(simulation_.runStart(), *output_.checkpointEvery, solver_.endTime);
  }

  RunResult operator()() {
    begin();
    const StopRequest stopRequest;
    Progress progress("run", solver_.endTime - simulation_.runStart(), options_.quiet);
    try {
      while (simulation_.time() < solver_.endTime) {
        {
          const auto stepping = clock_.lap(Activity::stepping);
          simulation_.advanceTo(nextTime(), [&] { return mayGoOn(progress); });
        }
        serveDueTimes();
        if (simulation_.time() < solver_.endTime && mayStop()) return stopped();
      }
    } catch (const std::exception& error) {
      simulation_.forgetPause();  // a step that failed is no place to go on from
      throw RunError(std::string(error.what()) + "; " + recorder_->saveFailed(simulation_) +
                     hintOfCheckpoints());
    }
    progress.finish(
        fmt::format("{} steps, {}", simulation_.nSteps(), recorder_->speed(simulation_, clock_)));
    return finished();
  }

 private:
  void begin() {
    if (simulation_.isContinued()) {
      states_.skipTo(simulation_.time());
      rows_.skipTo(simulation_.time());
      if (pauses_) pauses_->skipTo(simulation_.time());
    }
    const std::vector<Figure> row = measureState(simulation_, observers_, 0);
    requireDistinct(row);
    if (simulation_.isContinued()) History::requireColumns(options_.folder / "history.csv", row);
    validation_.emplace(settings_.validations, row);
    recorder_.emplace(options_, settings_, simulation_);
    if (!options_.quiet) std::cout << describeModel(simulation_) << std::flush;
    for (const auto& earlier : recorder_->earlierRows()) validation_->addRow(earlier);
    if (simulation_.isContinued()) return;
    recorder_->addState(simulation_);
    addRow(row);
    recorder_->drawFirst(simulation_);
  }

  double nextTime() const {
    const double next = std::min(states_.next(), rows_.next());
    return pauses_ ? std::min(next, pauses_->next()) : next;
  }

  void addRow(const std::vector<Figure>& row) {
    recorder_->addRow(row);
    validation_->addRow(row);
    simulation_.restartWallLoads();
  }

  void serveDueTimes() {
    const double time = simulation_.time();
    if (rows_.isDue(time)) {
      const auto measuring = clock_.lap(Activity::measuring);
      addRow(measureState(simulation_, observers_, recorder_->wallClock()));
      rows_.advance();
    }
    if (states_.isDue(time)) {
      const auto writing = clock_.lap(Activity::writing);
      recorder_->addState(simulation_);
      states_.advance();
    }
    if (pauses_ && pauses_->isDue(time)) {
      pauses_->advance();
      if (time >= solver_.endTime) return;  // the end file is one
      simulation_.preparePause();
      writeCheckpoint();
    }
  }

  /// After each step: whether the run goes on to the next due time.
  bool mayGoOn(Progress& progress) {
    progress.update(simulation_.time() - simulation_.runStart(),
                    fmt::format("t = {:.4g} s, step {}", simulation_.time(), simulation_.nSteps()));
    if (simulation_.time() >= nextTime()) return true;  // what is due is served first
    if (mayStop()) return false;
    if (isCheckpointDue() && simulation_.mayPause()) writeCheckpoint();
    return true;
  }

  bool mayStop() const { return StopRequest::signal() != 0 && simulation_.mayPause(); }

  bool isCheckpointDue() const {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - lastCheckpoint_;
    return since.count() > output_.checkpointWallClock;
  }

  std::filesystem::path writeCheckpoint() {
    const auto writing = clock_.lap(Activity::writing);
    lastCheckpoint_ = std::chrono::steady_clock::now();
    return checkpoints_.write(simulation_);
  }

  RunResult stopped() {
    RunResult result{recorder_->lastRow(), {}, StopRequest::signal(), writeCheckpoint()};
    return result;
  }

  RunResult finished() {
    std::vector<std::pair<std::string, double>> figures;
    for (const Figure& f : recorder_->lastRow())  // the file is the same however long it took
      if (!std::isnan(f.value) && f.name != "wall_clock") figures.emplace_back(f.name, f.value);
    simulation_.preparePause();
    simulation_.notePause();
    simulation_.describeState(fmt::format("plenum-sph {}", version), std::move(figures));
    RunResult result{recorder_->lastRow(), validation_->evaluate(), 0, {}};
    recorder_->finish(simulation_, result.validation, meanNeighbours(), clock_);
    return result;
  }

  /// Others in the support of a fluid particle, in the last step. None where particles have come or
  /// gone since it summed over pairs, or where there was no step.
  std::optional<double> meanNeighbours() {
    const std::size_t nFluid = simulation_.particles().nFluid();
    if (simulation_.time() <= simulation_.runStart() || solver_.hasStreams() || nFluid == 0)
      return std::nullopt;
    return countInteractions(simulation_.engine(), simulation_.particles(), false).ofFluids /
           static_cast<double>(nFluid);
  }

  std::string hintOfCheckpoints() const {
    const auto files = checkpoints_.all();
    return files.empty() ? "" : "; the last checkpoint is " + files.back().string();
  }

  CaseSettings settings_;
  RunOptions options_;
  SolverSettings solver_;
  OutputSettings output_;
  Simulation<Dim> simulation_;
  Observers<Dim> observers_;
  Schedule states_, rows_;
  std::optional<Schedule> pauses_;
  Checkpoints checkpoints_;
  std::chrono::steady_clock::time_point lastCheckpoint_ = std::chrono::steady_clock::now();
  std::optional<Validation> validation_;
  std::optional<Recorder<Dim>> recorder_;
  ActivityClock clock_;
};

}  // namespace

template <int Dim>
RunResult runScene(Scene<Dim> scene, const CaseSettings& settings, const RunOptions& options) {
  const SolverSettings solver = settings.solverOrDefaults();
  checkTimes(settings, scene.info.time, solver.smoothingLength * scene.info.spacing,
             largestSignalSpeed(scene.particles, solver,
                                Phases(scene.info.materials, solver).largestSoundSpeed()));
  return Run<Dim>(std::move(scene), settings, options)();
}

template RunResult runScene<1>(Scene<1>, const CaseSettings&, const RunOptions&);
template RunResult runScene<2>(Scene<2>, const CaseSettings&, const RunOptions&);
template RunResult runScene<3>(Scene<3>, const CaseSettings&, const RunOptions&);

}  // namespace plenum
