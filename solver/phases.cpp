// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/phases.hpp"

#include <algorithm>

namespace plenum {

namespace {

Tait stateOf(double density, const Material& material, const SolverSettings& s) {
  const double c = material.soundSpeed.value_or(s.soundSpeed);
  if (s.equationOfState == "isothermal")  // p = c^2 rho is Tait's with these
    return {.referenceDensity = density, .soundSpeed = c, .backgroundPressure = density * c * c};
  return {density, c, material.backgroundPressure.value_or(s.backgroundPressure),
          material.taitExponent.value_or(s.taitExponent),
          material.cavitationPressure.value_or(
              s.cavitationPressure.value_or(Tait{}.cavitationPressure))};
}

}  // namespace

Phases::Phases(const std::vector<Material>& materials, const SolverSettings& settings) {
  for (const Material& m : materials) {
    Phase phase{stateOf(m.density, m, settings)};
    if (const LaminarSettings* laminar = settings.laminar())
      phase.dynamicViscosity = m.dynamicViscosity.value_or(laminar->dynamicViscosity);
    phases_.push_back(phase);
  }
}

MaterialTable Phases::states() const {
  std::vector<Tait> rows;
  for (const Phase& phase : phases_) rows.push_back(phase.state);
  return MaterialTable(std::move(rows));
}

MaterialTable Phases::statesOf(const std::vector<Wall>& walls,
                               const SolverSettings& settings) const {
  std::vector<Tait> rows;
  for (const Wall& wall : walls) {
    const auto like = std::ranges::find_if(
        phases_, [&](const Phase& phase) { return phase.state.referenceDensity == wall.density; });
    rows.push_back(like == phases_.end() ? stateOf(wall.density, Material{}, settings)
                                         : like->state);
  }
  return MaterialTable(std::move(rows));
}

double Phases::largestSoundSpeed() const {
  double largest = 0;
  for (const Phase& phase : phases_) largest = std::max(largest, phase.state.soundSpeed);
  return largest;
}

double Phases::largestKinematicViscosity() const {
  double largest = 0;
  for (const Phase& phase : phases_) largest = std::max(largest, phase.kinematicViscosity());
  return largest;
}

bool Phases::differInSoundSpeed() const {
  return std::ranges::any_of(phases_, [&](const Phase& phase) {
    return phase.state.soundSpeed != phases_.front().state.soundSpeed;
  });
}

bool Phases::differInViscosity() const {
  return std::ranges::any_of(phases_, [&](const Phase& phase) {
    return phase.dynamicViscosity != phases_.front().dynamicViscosity;
  });
}

}  // namespace plenum
