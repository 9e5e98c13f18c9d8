// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/wall_motions.hpp"

#include "geometry/text_reader.hpp"
#include "ictools/motion_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace plenum {

namespace {

constexpr double degree = std::numbers::pi / 180;

std::array<double, 3> threeOf(const std::vector<double>& numbers) {
  std::array<double, 3> three{};
  std::ranges::copy(numbers, three.begin());
  return three;
}

Harmonic harmonicOf(const HarmonicKeys& keys) {
  return {keys.frequency, keys.phase * degree, keys.from,
          keys.until.value_or(std::numeric_limits<double>::infinity()), keys.ramp};
}

void setAxis(RigidMotion& motion, const Axis& axis) {
  motion.center = axis.center;
  motion.axis = axis.direction;
}

template <int Dim>
void addTable(const WallSettings& settings, const std::filesystem::path& folder,
              RigidMotion& motion) {
  const CaseNode& node = at(settings.node, "motion");
  const std::filesystem::path path = folder / settings.motion->table;
  MotionTableFile file = readMotionTable(readWholeFile(path), Dim, path.string());
  motion.table = std::move(file.table);
  if (!file.hasAngle) {
    for (const char* key : {"center", "axis"})
      if (const CaseNode* given = node.find(key))
        given->fail("goes with a column angle, which the table does not have; leave it out");
    return;
  }
  const Axis axis = axisOf(*settings.motion);
  const bool isOther = (settings.rotation && !(axisOf(*settings.rotation) == axis)) ||
                       (settings.rocking && !(axisOf(*settings.rocking) == axis));
  if (isOther)
    node.fail(
        "turns the wall about another centre or axis than `rotation` or `rocking`; give all the "
        "same ones, or leave the others out");
  setAxis(motion, axis);
}

std::string place(const std::array<double, 3>& x, int dimension) {
  return fmt::format("({:g})",
                     fmt::join(std::span(x).first(static_cast<std::size_t>(dimension)), ", "));
}

std::string about(const RigidMotion& motion, int dimension, const std::array<double, 3>& axis) {
  std::string text = " about " + place(motion.center, dimension);
  if (dimension == 3) text += ", axis " + place(axis, 3);
  return text;
}

std::string duration(const Harmonic& h) {
  std::string text;
  if (h.from > 0) text += fmt::format(" from {:g} s", h.from);
  if (std::isfinite(h.until)) text += fmt::format(" until {:g} s", h.until);
  return text;
}

}  // namespace

Axis axisFrom(const std::vector<double>& center, const std::vector<double>& axis) {
  Axis result{threeOf(center)};
  if (axis.empty()) return result;
  const std::array<double, 3> given = threeOf(axis);
  const double length = std::hypot(given[0], given[1], given[2]);
  for (std::size_t a = 0; a < 3; ++a) result.direction[a] = given[a] / length;
  return result;
}

template <int Dim>
RigidMotion rigidMotion(const WallSettings& settings, const std::filesystem::path& folder) {
  RigidMotion motion;
  motion.velocity = threeOf(settings.velocity);
  if (settings.rotation) {
    const RotationSettings& rotation = *settings.rotation;
    setAxis(motion, axisOf(rotation));
    const double omega =
        rotation.omega ? *rotation.omega : *rotation.rpm * 2 * std::numbers::pi / 60;
    for (std::size_t a = 0; a < 3; ++a) motion.angularVelocity[a] = omega * motion.axis[a];
  }
  if (settings.oscillation)
    motion.oscillation = {threeOf(settings.oscillation->amplitude),
                          harmonicOf(*settings.oscillation)};
  if (settings.rocking) {
    setAxis(motion, axisOf(*settings.rocking));
    motion.rocking = {settings.rocking->amplitude * degree, harmonicOf(*settings.rocking)};
  }
  if (settings.motion) addTable<Dim>(settings, folder, motion);
  return motion;
}

std::string describeMotion(const RigidMotion& motion, int dimension) {
  constexpr std::array<double, 3> zero{};
  std::vector<std::string> parts;
  if (motion.velocity != zero)
    parts.push_back(fmt::format("moves at {} m/s", place(motion.velocity, dimension)));
  if (motion.angularVelocity != zero) {
    std::array<double, 3> axis = motion.angularVelocity;
    const double rate = std::hypot(axis[0], axis[1], axis[2]);
    for (double& component : axis) component /= rate;
    parts.push_back(fmt::format("turns at {:g} rad/s{}", dimension == 2 ? rate * axis[2] : rate,
                                about(motion, dimension, axis)));
  }
  if (const Oscillation& o = motion.oscillation; o.amplitude != zero)
    parts.push_back(fmt::format("oscillates by {} m at {:g} 1/s{}", place(o.amplitude, dimension),
                                o.harmonic.frequency, duration(o.harmonic)));
  if (const Rocking& r = motion.rocking; r.amplitude != 0)
    parts.push_back(fmt::format("rocks by {:g} degrees at {:g} 1/s{}{}", r.amplitude / degree,
                                r.harmonic.frequency, about(motion, dimension, motion.axis),
                                duration(r.harmonic)));
  if (const MotionTable& t = motion.table; !t.empty())
    parts.push_back(fmt::format("follows a table of {} rows from {:g} s until {:g} s",
                                t.times.size(), t.times.front(), t.times.back()));
  return parts.empty() ? "still" : fmt::format("{}", fmt::join(parts, "; "));
}

template RigidMotion rigidMotion<1>(const WallSettings&, const std::filesystem::path&);
template RigidMotion rigidMotion<2>(const WallSettings&, const std::filesystem::path&);
template RigidMotion rigidMotion<3>(const WallSettings&, const std::filesystem::path&);

}  // namespace plenum
