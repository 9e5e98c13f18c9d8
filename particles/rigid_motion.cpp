// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/rigid_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plenum {

namespace {

using Three = std::array<double, 3>;

Three cross(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double length(const Three& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

bool isFinite(const Three& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

bool rocksOrFollowsATable(const RigidMotion& motion) {
  return motion.rocking.amplitude != 0 || !motion.table.empty();
}

/// The unit vector of all rotations.
Three axisOf(const RigidMotion& motion) {
  const Three& w = motion.angularVelocity;
  const double rate = length(w);
  if (rocksOrFollowsATable(motion) || !(rate > 0)) return motion.axis;
  return {w[0] / rate, w[1] / rate, w[2] / rate};
}

/// All angles but that of the constant angular velocity [rad].
Signal variableAngle(const RigidMotion& motion, double time) {
  const Signal rocking = motion.rocking.harmonic.at(time);
  const Signal table = motion.table.at(time)[3];
  const double amplitude = motion.rocking.amplitude;
  return {amplitude * rocking.value + table.value, amplitude * rocking.rate + table.rate,
          amplitude * rocking.secondRate + table.secondRate};
}

/// S(q) of a ramp that lasts one unit of time, 0 <= q <= 1.
Signal smoothStep(double q) {
  const double p = 1 - q;
  return {q * q * q * (10 - 15 * q + 6 * q * q), 30 * q * q * p * p, 60 * q * p * (p - q)};
}

/// e(t) of a harmonic signal between its beginning and its end.
Signal envelope(const Harmonic& h, double time) {
  const double sinceStart = time - h.from, untilEnd = h.until - time;
  if (!(h.ramp > 0) || (sinceStart >= h.ramp && untilEnd >= h.ramp)) return {1, 0, 0};
  const bool grows = sinceStart < h.ramp;
  const Signal s = smoothStep((grows ? sinceStart : untilEnd) / h.ramp);
  return {s.value, (grows ? s.rate : -s.rate) / h.ramp, s.secondRate / (h.ramp * h.ramp)};
}

std::optional<std::string> faultOf(const Harmonic& h) {
  if (!(h.frequency >= 0) || !std::isfinite(h.frequency) || !std::isfinite(h.phase))
    return fmt::format("a frequency of {} 1/s and a phase of {} rad", h.frequency, h.phase);
  if (!(h.from >= 0) || !std::isfinite(h.from) || !(h.until > h.from))
    return fmt::format("a harmonic motion from {} s until {} s", h.from, h.until);
  if (!(h.ramp >= 0) || !std::isfinite(h.ramp) || !(2 * h.ramp <= h.until - h.from))
    return fmt::format("a ramp of {} s from {} s until {} s", h.ramp, h.from, h.until);
  return std::nullopt;
}

std::optional<std::string> faultOf(const MotionTable& table) {
  if (table.places.size() != table.times.size() || table.times.size() == 1)
    return fmt::format("a table of {} times and {} places", table.times.size(),
                       table.places.size());
  for (std::size_t k = 0; k < table.times.size(); ++k) {
    if (!std::isfinite(table.times[k]) ||
        !std::ranges::all_of(table.places[k], [](double x) { return std::isfinite(x); }))
      return fmt::format("row {} of a table that is not finite", k + 1);
    if (k > 0 && !(table.times[k] > table.times[k - 1]))
      return fmt::format("a table with {} s after {} s", table.times[k], table.times[k - 1]);
  }
  return std::nullopt;
}

}  // namespace

Signal Harmonic::at(double time) const {
  const double start = ramp > 0 ? 0 : std::sin(phase);
  if (!(time >= from)) return {};
  const double omega = 2 * std::numbers::pi * frequency;
  if (time >= until) return {ramp > 0 ? 0 : std::sin(omega * (until - from) + phase) - start, 0, 0};
  const double angle = omega * (time - from) + phase;
  const double s = std::sin(angle), rate = omega * std::cos(angle), second = -omega * omega * s;
  const Signal e = envelope(*this, time);
  return {e.value * s - start, e.rate * s + e.value * rate,
          e.secondRate * s + 2 * e.rate * rate + e.value * second};
}

double MotionTable::tangent(std::size_t row, std::size_t column) const {
  if (row == 0 || row + 1 == times.size()) return 0;
  const double before = times[row] - times[row - 1], after = times[row + 1] - times[row];
  const double slopeBefore = (places[row][column] - places[row - 1][column]) / before;
  const double slopeAfter = (places[row + 1][column] - places[row][column]) / after;
  return (after * slopeBefore + before * slopeAfter) / (before + after);
}

std::array<Signal, MotionTable::nColumns> MotionTable::at(double time) const {
  std::array<Signal, nColumns> result;
  if (empty()) return result;
  const bool isBefore = !(time >= times.front());
  if (isBefore || time >= times.back()) {
    const auto& place = isBefore ? places.front() : places.back();
    for (std::size_t c = 0; c < nColumns; ++c) result[c].value = place[c];
    return result;
  }
  const auto next = static_cast<std::size_t>(std::ranges::upper_bound(times, time) - times.begin());
  const double h = times[next] - times[next - 1];
  const double u = (time - times[next - 1]) / h;
  for (std::size_t c = 0; c < nColumns; ++c) {
    const double start = places[next - 1][c], way = places[next][c] - start;
    const double m0 = h * tangent(next - 1, c), m1 = h * tangent(next, c);
    const double a = m0 + m1 - 2 * way, b = 3 * way - 2 * m0 - m1;  // a u^3 + b u^2 + m0 u
    result[c] = {start + u * (m0 + u * (b + u * a)), (m0 + u * (2 * b + 3 * u * a)) / h,
                 (2 * b + 6 * u * a) / (h * h)};
  }
  return result;
}

bool RigidMotion::isStill() const {
  constexpr Three zero{};
  return velocity == zero && angularVelocity == zero && oscillation.amplitude == zero &&
         rocking.amplitude == 0 && table.empty();
}

std::optional<std::string> faultOf(const RigidMotion& motion) {
  for (const Three* vector : {&motion.velocity, &motion.angularVelocity, &motion.center,
                              &motion.axis, &motion.oscillation.amplitude})
    if (!isFinite(*vector)) return "a vector that is not finite";
  if (!std::isfinite(motion.rocking.amplitude)) return "an amplitude that is not finite";
  if (auto fault = faultOf(motion.oscillation.harmonic)) return fault;
  if (auto fault = faultOf(motion.rocking.harmonic)) return fault;
  if (auto fault = faultOf(motion.table)) return fault;
  if (!rocksOrFollowsATable(motion)) return std::nullopt;
  constexpr double roundOff = 1e-12;  // of a division and a few products
  if (!(std::abs(length(motion.axis) - 1) < roundOff)) return "an axis that is no unit vector";
  const double rate = length(motion.angularVelocity);
  if (length(cross(motion.angularVelocity, motion.axis)) > roundOff * rate)
    return "rotations about two axes";
  return std::nullopt;
}

MotionState::MotionState(const RigidMotion& motion, double time)
    : center(motion.center), velocity(motion.velocity), angularVelocity(motion.angularVelocity) {
  const Signal oscillation = motion.oscillation.harmonic.at(time);
  const auto table = motion.table.at(time), atZero = motion.table.at(0);
  const Signal angle = variableAngle(motion, time);
  for (std::size_t a = 0; a < 3; ++a) {
    const double amplitude = motion.oscillation.amplitude[a];
    center[a] += motion.velocity[a] * time + amplitude * oscillation.value +
                 (table[a].value - atZero[a].value);
    velocity[a] += amplitude * oscillation.rate + table[a].rate;
    acceleration[a] = amplitude * oscillation.secondRate + table[a].secondRate;
    angularVelocity[a] += angle.rate * motion.axis[a];
    angularAcceleration[a] = angle.secondRate * motion.axis[a];
  }
}

template <int Dim>
Vec<Dim> MotionState::velocityAt(const Vec<Dim>& x) const {
  const Three arm = toThree(x - fromThree<Dim>(center));
  return fromThree<Dim>(velocity) + fromThree<Dim>(cross(angularVelocity, arm));
}

template <int Dim>
Vec<Dim> MotionState::accelerationAt(const Vec<Dim>& x) const {
  const Three arm = toThree(x - fromThree<Dim>(center));
  return fromThree<Dim>(acceleration) + fromThree<Dim>(cross(angularAcceleration, arm)) +
         fromThree<Dim>(cross(angularVelocity, cross(angularVelocity, arm)));
}

Displacement::Displacement(const RigidMotion& motion, double before, double after)
    : centerBefore(MotionState(motion, before).center),
      centerAfter(MotionState(motion, after).center) {
  const Three axis = axisOf(motion);
  const Three& w = motion.angularVelocity;
  const double rate = w[0] * axis[0] + w[1] * axis[1] + w[2] * axis[2];
  const double angle = rate * (after - before) +
                       (variableAngle(motion, after).value - variableAngle(motion, before).value);
  const double c = std::cos(angle), s = std::sin(angle);
  // Rodrigues' formula, column by column.
  for (std::size_t k = 0; k < 3; ++k) {
    Three unit{};
    unit[k] = 1;
    const Three across = cross(axis, unit);
    for (std::size_t a = 0; a < 3; ++a)
      turn[a][k] = c * unit[a] + s * across[a] + (1 - c) * axis[k] * axis[a];
  }
}

template Vec<1> MotionState::velocityAt(const Vec<1>&) const;
template Vec<2> MotionState::velocityAt(const Vec<2>&) const;
template Vec<3> MotionState::velocityAt(const Vec<3>&) const;
template Vec<1> MotionState::accelerationAt(const Vec<1>&) const;
template Vec<2> MotionState::accelerationAt(const Vec<2>&) const;
template Vec<3> MotionState::accelerationAt(const Vec<3>&) const;

}  // namespace plenum
