// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run.hpp"

#include "particles/errors.hpp"
#include "particles/progress.hpp"
#include "solver/recorder.hpp"
#include "solver/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace plenum {

namespace {

void change(CaseNode& root, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    throw InputError(
        fmt::format("--set {}: write key=value, for instance "
                    "--set solver.kernel=convex",
                    assignment));
  const std::string key = assignment.substr(0, equals);
  const auto belongsTo = [&](const char* section) {
    return key.starts_with(std::string(section) + ".");
  };
  if (!belongsTo("solver") && !belongsTo("output") && !belongsTo("measures"))
    throw InputError(
        fmt::format("--set {}: only keys of solver, output and measures can change once the "
                    "particles are made; "
                    "change the case and run plenum-ic generate again",
                    assignment));
  root.set(key, assignment.substr(equals + 1));
}

}  // namespace

template <int Dim>
CaseSettings settingsOf(const SceneInfo<Dim>& info, const std::vector<std::string>& changes) {
  CaseNode root = CaseNode::parse(info.caseText, info.caseName);
  for (const std::string& assignment : changes) change(root, assignment);
  return readCase(root);
}

template <int Dim>
std::vector<Figure> runScene(Scene<Dim> scene, const CaseSettings& settings,
                             const RunOptions& options) {
  const SolverSettings solver = settings.solverOrDefaults();
  const OutputSettings output = settings.outputOrDefaults();
  const double start = scene.info.time;
  Simulation<Dim> simulation(std::move(scene), solver);
  if (solver.endTime < start)
    throw InputError(fmt::format("solver.end_time = {:g} s lies before the state's time {:g} s",
                                 solver.endTime, start));
  Recorder<Dim> recorder(options, settings, simulation);
  if (!options.quiet) std::cout << describeModel(simulation) << std::flush;

  recorder.addState(simulation);
  recorder.addRow(simulation);
  recorder.drawFirst(simulation);
  Schedule states(start, output.every, solver.endTime);
  Schedule rows(start, output.historyEvery.value_or(output.every), solver.endTime);
  Progress progress("run", solver.endTime - start, options.quiet);
  try {
    while (simulation.time() < solver.endTime) {
      simulation.advanceTo(std::min(states.next(), rows.next()), [&] {
        progress.update(
            simulation.time() - start,
            fmt::format("t = {:.4g} s, step {}", simulation.time(), simulation.nSteps()));
      });
      if (rows.isDue(simulation.time())) {
        recorder.addRow(simulation);
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
  recorder.finish(simulation);
  return recorder.lastRow();
}

template CaseSettings settingsOf<1>(const SceneInfo<1>&, const std::vector<std::string>&);
template CaseSettings settingsOf<2>(const SceneInfo<2>&, const std::vector<std::string>&);
template CaseSettings settingsOf<3>(const SceneInfo<3>&, const std::vector<std::string>&);
template std::vector<Figure> runScene<1>(Scene<1>, const CaseSettings&, const RunOptions&);
template std::vector<Figure> runScene<2>(Scene<2>, const CaseSettings&, const RunOptions&);
template std::vector<Figure> runScene<3>(Scene<3>, const CaseSettings&, const RunOptions&);

}  // namespace plenum
