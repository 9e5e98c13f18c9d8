// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "particles/scene.hpp"
#include "solver/figure.hpp"
#include "solver/simulation.hpp"
#include "solver/validation.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace plenum {

struct RunOptions {
  std::filesystem::path folder;  ///< where everything is written
  std::string name;              ///< of the scene, first part of file names
  bool quiet = false;
  bool anew = false;  ///< begins again where the folder holds checkpoints of a run without an end
};

/// What a run leaves to say.
struct RunResult {
  std::vector<Figure> figures;               ///< of the last state
  std::vector<ValidationResult> validation;  ///< of the case's [[validate]]
  int signal = 0;                            ///< that it was stopped by; 0: it came to its end
  std::filesystem::path checkpoint;          ///< where a stopped run goes on from
};

/// Settings of the run: the case text in the particle file, changed by "key=value" pairs that may
/// name keys of [solver], [output], [measures] and [[validate]] only; of a run that is continued,
/// no key of [solver] but end_time. The changes become part of the case text. Throws InputError.
template <int Dim>
CaseSettings settingsOf(SceneInfo<Dim>& info, const std::vector<std::string>& changes,
                        bool isContinued = false);

/// Refuses times that cannot be meant; warns of a fixed step that is likely too long and of a sum
/// of densities under gravity. `start` is the time of the state [s], h the smoothing length [m], c
/// the largest speed of sound [m/s].
void checkTimes(const CaseSettings& settings, double start, double h, double c);

/// Runs a scene to its end time and writes VTU files, their .pvd, history.csv, summary.json,
/// pictures of the first and the last state, checkpoints, and the last state as a particle file. A
/// scene with progress (a checkpoint) goes on with its run. SIGINT and SIGTERM end the run with a
/// checkpoint. If the run fails, the last finite state is written before the RunError leaves.
/// Throws InputError, before anything is written, for measures that the scene cannot have.
template <int Dim>
RunResult runScene(Scene<Dim> scene, const CaseSettings& settings, const RunOptions& options);

/// What is modelled, what is not, and what a particle costs; lines for people.
template <int Dim>
std::string describeModel(const Simulation<Dim>& simulation);

}  // namespace plenum
