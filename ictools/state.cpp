// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/state.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plenum {

InitialState::InitialState(const SolverSettings& solver, double referenceDensity,
                           std::optional<double> pressure,
                           const std::optional<HydrostaticSettings>& hydrostatic,
                           const CaseNode& table)
    : solver_(solver),
      referenceDensity_(referenceDensity),
      pressure_(pressure.value_or(solver.backgroundPressure)),
      isGiven_(pressure.has_value()),
      table_(table) {
  if (!hydrostatic) return;
  double squares = 0;
  for (double component : solver.gravity) squares += component * component;
  gravity_ = std::sqrt(squares);
  if (gravity_ == 0)
    at(table, "hydrostatic")
        .fail("needs gravity: set solver.gravity, e.g. gravity = [0, -9.81], or give a pressure");
  surface_ = hydrostatic->surface;
  pressure_ = hydrostatic->pressureAtSurface.value_or(solver.backgroundPressure);
}

template <int Dim>
FluidState InitialState::operator()(const Vec<Dim>& x) const {
  FluidState state{pressure_, referenceDensity_};
  if (gravity_ > 0) {
    double height = 0;  // against gravity
    for (int a = 0; a < Dim; ++a)
      height -= x[a] * solver_.gravity[static_cast<std::size_t>(a)] / gravity_;
    state.pressure += referenceDensity_ * gravity_ * (surface_ - height);
  }
  const double c2 = solver_.soundSpeed * solver_.soundSpeed;
  const double excess = (state.pressure - solver_.backgroundPressure) / (referenceDensity_ * c2);
  const double gamma = solver_.taitExponent;
  const double base = 1 + gamma * excess;
  if (!(base > 0))
    table_.fail(fmt::format(
        "pressure {:g} has no density at sound speed {:g} m/s; raise solver.sound_speed or the "
        "pressure",
        state.pressure, solver_.soundSpeed));
  state.density = referenceDensity_ * (gamma == 1 ? base : std::pow(base, 1 / gamma));
  return state;
}

FluidState InitialState::withDensity(double density) const {
  if (isGiven_) return {pressure_, density};
  const double gamma = solver_.taitExponent;
  const double stiffness = referenceDensity_ * solver_.soundSpeed * solver_.soundSpeed / gamma;
  return {
      solver_.backgroundPressure + stiffness * (std::pow(density / referenceDensity_, gamma) - 1),
      density};
}

template FluidState InitialState::operator()(const Vec<1>&) const;
template FluidState InitialState::operator()(const Vec<2>&) const;
template FluidState InitialState::operator()(const Vec<3>&) const;

}  // namespace plenum
