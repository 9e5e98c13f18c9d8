// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/step_record.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plenum {

std::vector<std::pair<std::string, double>> StepRecord::progress() const {
  return {{"step", static_cast<double>(nSteps)},
          {"run_start", runStart},
          {"largest_acceleration", largestAcceleration},
          {"fastest", fastest},
          {"largest_rate", largestRate}};
}

void StepRecord::restore(const std::vector<std::pair<std::string, double>>& progress) {
  const auto value = [&](const char* name) {
    const auto found =
        std::ranges::find(progress, name, [](const auto& figure) { return figure.first; });
    if (found == progress.end())
      throw InputError(
          fmt::format("the file says that a run paused here, but not its {}; start a "
                      "new one with `plenum-sph run`",
                      name));
    return found->second;
  };
  nSteps = static_cast<long>(value("step"));
  runStart = value("run_start");
  largestAcceleration = value("largest_acceleration");
  fastest = value("fastest");
  largestRate = value("largest_rate");
}

}  // namespace plenum
