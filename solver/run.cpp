// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run.hpp"

#include "particles/errors.hpp"
#include "particles/progress.hpp"
#include "particles/version.hpp"
#include "solver/recorder.hpp"
#include "solver/schedule.hpp"
#include "solver/state_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace plenum {

namespace {

void change(CaseNode& root, const std::string& assignment) {
  const auto [key, value] = CaseNode::splitAssignment(assignment);
  const std::string section = key.substr(0, key.find_first_of(".["));
  if (section != "solver" && section != "output" && section != "measures" && section != "validate")
    throw InputError(
        fmt::format("--set {}: only keys of solver, output, measures and validate can change once "
                    "the particles are made; change the case and run plenum-ic generate again",
                    assignment));
  root.set(key, value);
}

/// Refuses times that cannot be meant; warns of a fixed step that is likely too long.
void checkTimes(const CaseSettings& settings, double start, double h) {
  const SolverSettings solver = settings.solverOrDefaults();
  const OutputSettings output = settings.outputOrDefaults();
  const double duration = solver.endTime - start;
  if (duration < 0)
    throw InputError(fmt::format("solver.end_time = {:g} s lies before the state's time {:g} s",
                                 solver.endTime, start));
  const auto requireFew = [&](const char* key, double interval, double most, const char* what) {
    if (duration / interval > most)
      throw InputError(
          fmt::format("{} = {:g} s would make {:g} {} until {:g} s; at most {:g} are "
                      "allowed",
                      key, interval, duration / interval, what, solver.endTime, most));
  };
  requireFew("output.every", output.every, 1e5, "files");
  requireFew("output.history_every", output.historyEvery.value_or(output.every), 1e7, "rows");
  const double acoustic = h / solver.soundSpeed;
  requireFew("solver.time_step", solver.timeStep.value_or(solver.cfl * acoustic), 1e12, "steps");
  if (solver.timeStep && *solver.timeStep > acoustic)
    std::cerr << fmt::format(
        "plenum-sph: warning: solver.time_step = {:g} s is longer than h/c = "
        "{:g} s; a stable step is about {:g} s\n",
        *solver.timeStep, acoustic, 0.2 * acoustic);
}

}  // namespace

template <int Dim>
CaseSettings settingsOf(const SceneInfo<Dim>& info, const std::vector<std::string>& changes) {
  CaseNode root = CaseNode::parse(info.caseText, info.caseName);
  for (const std::string& assignment : changes) change(root, assignment);
  return readCase(root);
}

template <int Dim>
RunResult runScene(Scene<Dim> scene, const CaseSettings& settings, const RunOptions& options) {
  const SolverSettings solver = settings.solverOrDefaults();
  const OutputSettings output = settings.outputOrDefaults();
  const double start = scene.info.time;
  checkTimes(settings, start, solver.smoothingLength * scene.info.spacing);
  Simulation<Dim> simulation(std::move(scene), solver);
  const Observers<Dim> observers(settings.measuresOrDefaults(), observed(simulation));
  const auto firstRow = measureState(simulation, observers, 0);
  requireDistinct(firstRow);
  Validation validation(settings.validations, firstRow);
  Recorder<Dim> recorder(options, settings, simulation);
  const auto addRow = [&](const std::vector<Figure>& row) {
    recorder.addRow(row);
    validation.addRow(row);
  };
  if (!options.quiet) std::cout << describeModel(simulation) << std::flush;

  recorder.addState(simulation);
  addRow(firstRow);
  recorder.drawFirst(simulation);
  Schedule states(start, output.every, solver.endTime);
  Schedule rows(start, output.historyEvery.value_or(output.every), solver.endTime,
                Validation::timesOf(settings.validations));
  Progress progress("run", solver.endTime - start, options.quiet);
  try {
    while (simulation.time() < solver.endTime) {
      simulation.advanceTo(std::min(states.next(), rows.next()), [&] {
        progress.update(
            simulation.time() - start,
            fmt::format("t = {:.4g} s, step {}", simulation.time(), simulation.nSteps()));
      });
      if (rows.isDue(simulation.time())) {
        addRow(measureState(simulation, observers, recorder.wallClock()));
        rows.advance();
      }
      if (states.isDue(simulation.time())) {
        recorder.addState(simulation);
        states.advance();
      }
    }
  } catch (const std::exception& error) {
    throw RunError(std::string(error.what()) + "; " + recorder.saveFailed(simulation));
  }
  progress.finish(fmt::format("{} steps", simulation.nSteps()));
  std::vector<std::pair<std::string, double>> figures;
  for (const Figure& f : recorder.lastRow())
    if (!std::isnan(f.value)) figures.emplace_back(f.name, f.value);
  simulation.describeState(fmt::format("plenum-sph {}", version), std::move(figures));
  RunResult result{recorder.lastRow(), validation.evaluate()};
  recorder.finish(simulation, result.validation);
  return result;
}

template CaseSettings settingsOf<1>(const SceneInfo<1>&, const std::vector<std::string>&);
template CaseSettings settingsOf<2>(const SceneInfo<2>&, const std::vector<std::string>&);
template CaseSettings settingsOf<3>(const SceneInfo<3>&, const std::vector<std::string>&);
template RunResult runScene<1>(Scene<1>, const CaseSettings&, const RunOptions&);
template RunResult runScene<2>(Scene<2>, const CaseSettings&, const RunOptions&);
template RunResult runScene<3>(Scene<3>, const CaseSettings&, const RunOptions&);

}  // namespace plenum
