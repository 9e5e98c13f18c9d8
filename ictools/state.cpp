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

FluidState InitialState::withPressure(double pressure) const {
  const double c2 = solver_.soundSpeed * solver_.soundSpeed, gamma = solver_.taitExponent;
  const double excess = (pressure - solver_.backgroundPressure) / (referenceDensity_ * c2);
  const double base = 1 + gamma * excess;
  if (!(base > 0)) failWithoutDensity(pressure);
  return {pressure, referenceDensity_ * (gamma == 1 ? base : std::pow(base, 1 / gamma))};
}

template <int Dim>
FluidState InitialState::operator()(const Vec<Dim>& x) const {
  const double c2 = solver_.soundSpeed * solver_.soundSpeed, gamma = solver_.taitExponent;
  const FluidState atSurface = withPressure(pressure_);
  if (gravity_ == 0) return atSurface;
  const double ratio = atSurface.density / referenceDensity_;
  double depth = surface_;
  for (int a = 0; a < Dim; ++a)
    depth += x[a] * solver_.gravity[static_cast<std::size_t>(a)] / gravity_;
  const double rise = gravity_ * depth / c2;
  if (gamma == 1) return withDensity(referenceDensity_ * ratio * std::exp(rise));
  const double power = std::pow(ratio, gamma - 1) + (gamma - 1) * rise;
  if (!(power > 0)) failWithoutDensity(pressure_ + referenceDensity_ * gravity_ * depth);
  return withDensity(referenceDensity_ * std::pow(power, 1 / (gamma - 1)));
}

void InitialState::failWithoutDensity(double pressure) const {
  table_.fail(fmt::format(
      "pressure {:g} has no density at sound speed {:g} m/s; raise solver.sound_speed or the "
      "pressure",
      pressure, solver_.soundSpeed));
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
