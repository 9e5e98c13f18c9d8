// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a [[wall]] that say how it moves.
#pragma once

#include "particles/section.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum {

struct WallSettings;

struct RotationSettings {
  std::optional<double> rpm;
  std::optional<double> omega;
  std::vector<double> center;
  std::vector<double> axis;
};

/// A motion to and fro (Harmonic, particles/rigid_motion.hpp).
struct HarmonicKeys {
  double frequency = 1;         ///< [1/s]
  double phase = 0;             ///< [degrees]
  double from = 0;              ///< [s]
  std::optional<double> until;  ///< [s]; absent: for ever
  double ramp = 0;              ///< [s]
};

struct OscillationSettings : HarmonicKeys {
  std::vector<double> amplitude;  ///< [m]
};

struct RockingSettings : HarmonicKeys {
  double amplitude = 0;  ///< [degrees]
  std::vector<double> center;
  std::vector<double> axis;
};

struct TableMotionSettings {
  std::string table;  ///< path of the file
  std::vector<double> center;
  std::vector<double> axis;
};

Section<RotationSettings> wallRotationSection();
Section<OscillationSettings> oscillationSection();
Section<RockingSettings> rockingSection();
Section<TableMotionSettings> tableMotionSection();

/// Throws InputError for motions that have no sense, or none together.
void checkMotions(const WallSettings& wall, int dimension);

}  // namespace plenum
