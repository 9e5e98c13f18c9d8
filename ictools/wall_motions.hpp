// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the keys of a [[wall]] to its motion.
#pragma once

#include "ictools/ic_settings.hpp"
#include "particles/rigid_motion.hpp"

#include <array>
#include <filesystem>
#include <string>

namespace plenum {

/// A line about which a wall turns.
struct Axis {
  std::array<double, 3> center{};            ///< [m]
  std::array<double, 3> direction{0, 0, 1};  ///< unit vector

  bool operator==(const Axis&) const = default;
};

/// Of settings with the keys center and axis.
Axis axisFrom(const std::vector<double>& center, const std::vector<double>& axis);
template <class Settings>
Axis axisOf(const Settings& settings) {
  return axisFrom(settings.center, settings.axis);
}

/// The motion of a wall; tables are read from files in `folder`. Throws InputError for a table that
/// cannot be read or that does not go with the other keys.
template <int Dim>
RigidMotion rigidMotion(const WallSettings& settings, const std::filesystem::path& folder);

/// What moves and how, in words: "turns at 104.7 rad/s about (0, 0)"; "still" if nothing does.
std::string describeMotion(const RigidMotion& motion, int dimension);

}  // namespace plenum
