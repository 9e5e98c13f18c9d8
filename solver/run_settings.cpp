// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/errors.hpp"
#include "solver/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace plenum {

namespace {

/// Whether a key, "solver.end_time", belongs to a section or is it.
bool isIn(const std::string& key, const std::string& section) {
  return key == section || key.starts_with(section + ".") || key.starts_with(section + "[");
}

/// A run that goes on must stay the same run.
void requireSameRun(const std::string& key, const std::string& assignment) {
  if (!isIn(key, "solver") || key == "solver.end_time") return;
  throw InputError(fmt::format(
      "--set {}: a run that is resumed keeps its physics; of [solver] only end_time can change. To "
      "begin a new run from this state use `plenum-sph run`",
      assignment));
}

}  // namespace

template <int Dim>
CaseSettings settingsOf(SceneInfo<Dim>& info, const std::vector<std::string>& changes,
                        bool isContinued) {
  CaseNode root = CaseNode::parse(info.caseText, info.caseName);
  for (const std::string& assignment : changes) {
    const auto [key, value] = CaseNode::splitAssignment(assignment);
    if (!isIn(key, "solver") && !isIn(key, "output") && !isIn(key, "measures") &&
        !isIn(key, "validate"))
      throw InputError(fmt::format(
          "--set {}: only keys of solver, output, measures and validate can change once "
          "the particles are made; change the case and run plenum-ic generate again",
          assignment));
    if (isContinued) requireSameRun(key, assignment);
    root.set(key, value);
  }
  const CaseSettings settings = readCase(root);
  if (!changes.empty())
    info.caseText = root.printedFile(info.caseName + " with values set on the command line");
  return settings;
}

void checkTimes(const CaseSettings& settings, double start, double h, double c) {
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
  if (output.checkpointEvery)
    requireFew("output.checkpoint_every", *output.checkpointEvery, 1e6, "checkpoints");
  const double acoustic = h / c;
  if (solver.timeStep)
    requireFew("solver.time_step", *solver.timeStep, 1e12, "steps");
  else
    requireFew("solver.cfl: time steps of about", solver.cfl * acoustic, 1e12, "steps");
  if (solver.timeStep && *solver.timeStep > acoustic && *solver.timeStep <= 2 * acoustic)
    std::cerr << fmt::format(
        "plenum-sph: warning: solver.time_step = {:g} s is longer than h/c = "
        "{:g} s; a stable step is about {:g} s\n",
        *solver.timeStep, acoustic, 0.2 * acoustic);
  const bool falls = std::ranges::any_of(solver.gravity, [](double g) { return g != 0; });
  if (solver.equationOfState == "tait" && solver.sumsDensity() && falls)
    std::cerr
        << "plenum-sph: warning: solver.density = \"summation\" with gravity: a sum is too low at "
           "a free surface, which makes energy from nothing; unless the fluid fills its domain, "
           "set density = \"continuity\" (docs/liquids.md)\n";
}

template CaseSettings settingsOf<1>(SceneInfo<1>&, const std::vector<std::string>&, bool);
template CaseSettings settingsOf<2>(SceneInfo<2>&, const std::vector<std::string>&, bool);
template CaseSettings settingsOf<3>(SceneInfo<3>&, const std::vector<std::string>&, bool);

}  // namespace plenum
