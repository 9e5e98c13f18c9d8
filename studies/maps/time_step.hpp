// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study stability time-step: the largest step that a scene stands, by bisection.
#pragma once

#include "studies/maps/map_files.hpp"

#include <string>
#include <vector>

namespace plenum::study {

struct TimeStepOptions {
  MapOptions common;
  std::vector<std::string> scenes{"box", "tank", "shaft", "dam"};
  std::vector<double> alphas{0, 0.01, 0.1, 0.5, 1, 2};  ///< of Monaghan's viscosity
};

/// The names that `scenes` may have.
std::vector<std::string> timeStepScenes();

/// Throws InputError, before anything runs, for options that cannot be used.
void runTimeStep(const TimeStepOptions& options);

}  // namespace plenum::study
