// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

double longestTimeStep(const SolverSettings& settings, const Phases& phases, double h,
                       const StepRecord& last) {
  if (settings.timeStep) return *settings.timeStep;
  if (settings.hasOwnLengths()) return settings.cfl / last.largestRate;
  const double bySignal = h / (phases.largestSoundSpeed() + last.fastest);
  const double byForce =
      last.largestAcceleration > 0 ? std::sqrt(h / last.largestAcceleration) : bySignal;
  const double step = settings.cfl * std::min(bySignal, byForce);
  const double nu = phases.largestKinematicViscosity();
  return nu > 0 ? std::min(step, 0.125 * h * h / nu) : step;
}

bool isSenseless(double step, const SolverSettings& settings, const Phases& phases, double h) {
  if (settings.hasOwnLengths()) return !(step > 1e-10 * settings.endTime);
  return !(step > 1e-6 * h / phases.largestSoundSpeed()) &&
         !(step > 1e-3 * h * h / phases.largestKinematicViscosity());
}

}  // namespace plenum
