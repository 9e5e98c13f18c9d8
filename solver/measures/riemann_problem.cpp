// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/riemann_problem.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

GasState mirrored(const GasState& gas) { return {gas.density, -gas.velocity, gas.pressure}; }

void requireGas(const GasState& gas, const char* side) {
  if (!(gas.density > 0) || !(gas.pressure > 0) || !std::isfinite(gas.velocity))
    throw InputError(fmt::format(
        "the gas on the {} has density {:g}, velocity {:g}, pressure {:g}: density and pressure "
        "must be above zero (vacuum has no particles), the velocity finite",
        side, gas.density, gas.velocity, gas.pressure));
}

}  // namespace

RiemannProblem::RiemannProblem(const GasState& left, const GasState& right, double gamma)
    : gamma_(gamma) {
  requireGas(left, "left");
  requireGas(right, "right");
  if (!(gamma >= 1)) throw InputError(fmt::format("gamma = {:g}: must be at least 1", gamma));
  left_.ahead = left;
  right_.ahead = mirrored(right);
  for (Side* side : {&left_, &right_})
    side->soundSpeed = std::sqrt(gamma * side->ahead.pressure / side->ahead.density);
  // The velocities of the sides towards each other: their sum is u_L - u_R.
  const double approach = left_.ahead.velocity + right_.ahead.velocity;
  const double escape = 2 * (left_.soundSpeed + right_.soundSpeed) / (gamma - 1);
  if (gamma > 1 && -approach >= escape)
    throw InputError(fmt::format(
        "the two sides part at {:g} m/s: from {:g} m/s on there is vacuum between them, which "
        "particles cannot show; choose velocities that differ less",
        -approach, escape));
  const double pressure = solveForPressure();
  const double velocity = 0.5 * (left_.ahead.velocity - velocityChange(left_, pressure) -
                                 right_.ahead.velocity + velocityChange(right_, pressure));
  makeWave(left_, pressure, velocity);
  makeWave(right_, pressure, -velocity);
  Wave& wave = right_.wave;
  wave = {mirrored(wave.behind), wave.isShock, -wave.head, -wave.tail};
}

/// f_K(p) of Toro (4.6), (4.7): by how much the wave slows the gas that runs into it [m/s].
double RiemannProblem::velocityChange(const Side& side, double pressure) const {
  const GasState& gas = side.ahead;
  if (pressure > gas.pressure) {
    const double A = 2 / ((gamma_ + 1) * gas.density);
    const double B = (gamma_ - 1) / (gamma_ + 1) * gas.pressure;
    return (pressure - gas.pressure) * std::sqrt(A / (pressure + B));
  }
  const double logarithm = std::log(pressure / gas.pressure);
  const double z = (gamma_ - 1) / (2 * gamma_) * logarithm;
  return side.soundSpeed / gamma_ * logarithm * (z == 0 ? 1 : std::expm1(z) / z);
}

/// p* with f_L + f_R + u_R - u_L = 0, Toro (4.5); the left-hand side grows with p*.
double RiemannProblem::solveForPressure() const {
  const auto excess = [&](double p) {
    return velocityChange(left_, p) + velocityChange(right_, p) - left_.ahead.velocity -
           right_.ahead.velocity;
  };
  double lower = std::min(left_.ahead.pressure, right_.ahead.pressure);
  double upper = std::max(left_.ahead.pressure, right_.ahead.pressure);
  while (excess(lower) > 0 && lower > std::numeric_limits<double>::min()) lower *= 0.1;
  while (excess(upper) < 0 && upper < std::numeric_limits<double>::max()) upper *= 2;
  while (true) {
    const double middle = lower + 0.5 * (upper - lower);
    if (middle <= lower || middle >= upper) return middle;
    (excess(middle) > 0 ? upper : lower) = middle;
  }
}

void RiemannProblem::makeWave(Side& side, double pressure, double velocity) const {
  const GasState& gas = side.ahead;
  const double ratio = pressure / gas.pressure, G = (gamma_ - 1) / (gamma_ + 1);
  Wave& wave = side.wave;
  wave.isShock = ratio > 1;
  wave.behind = {gas.density, velocity, pressure};
  if (wave.isShock) {  // Toro (4.50), (4.52)
    wave.behind.density *= (ratio + G) / (G * ratio + 1);
    wave.head = wave.tail =
        gas.velocity - side.soundSpeed * std::sqrt((gamma_ + 1) / (2 * gamma_) * ratio +
                                                   (gamma_ - 1) / (2 * gamma_));
  } else {  // Toro (4.53) to (4.55)
    wave.behind.density *= std::pow(ratio, 1 / gamma_);
    wave.head = gas.velocity - side.soundSpeed;
    wave.tail = velocity - std::sqrt(gamma_ * pressure / wave.behind.density);
  }
}

/// Toro (4.56), with the Riemann invariant u + 2a/(gamma - 1) written without a division by zero.
GasState RiemannProblem::insideFan(const Side& side, double speed) const {
  const GasState& gas = side.ahead;
  const double a = side.soundSpeed;
  const double u = 2 / (gamma_ + 1) * (a + 0.5 * (gamma_ - 1) * gas.velocity + speed);
  const double change = (u - gas.velocity) / a;
  const double logarithm =
      gamma_ > 1 ? 2 / (gamma_ - 1) * std::log1p(-0.5 * (gamma_ - 1) * change) : -change;
  return {gas.density * std::exp(logarithm), u, gas.pressure * std::exp(gamma_ * logarithm)};
}

/// `side.ahead` and `speed` as with this side on the left.
GasState RiemannProblem::onSide(const Side& side, double speed) const {
  const bool isLeft = &side == &left_;
  const double head = isLeft ? side.wave.head : -side.wave.head;
  const double tail = isLeft ? side.wave.tail : -side.wave.tail;
  if (speed < head) return side.ahead;
  if (speed < tail) return insideFan(side, speed);
  return isLeft ? side.wave.behind : mirrored(side.wave.behind);
}

GasState RiemannProblem::at(double speed) const {
  if (speed < starVelocity()) return onSide(left_, speed);
  return mirrored(onSide(right_, -speed));
}

}  // namespace plenum
