// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scales of pictures: colour maps, ticks and the numbers beside them.
#pragma once

#include "particles/picture_canvas.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace plenum {

/// From dark blue (0) over green to yellow (1); its lightness grows evenly, so that equal steps of
/// the value look equal, also in grey print and to colour-blind eyes. NaN is magenta.
Colour sequentialColour(double t);

/// Colours that are easily told apart, repeated after eight.
Colour categoryColour(int k);

inline constexpr Colour wallGrey{150, 150, 150};
inline constexpr Colour paleGrey{214, 214, 214};

struct Ticks {
  std::vector<double> at;
  std::vector<std::string> labels;
  int exponent = 0;  ///< labels are in units of 10^exponent, a multiple of three
};

/// Round numbers (1, 2, 5 times a power of ten) in [lower, upper], about `wanted` of them.
Ticks niceTicks(double lower, double upper, int wanted);

/// "velocity [10⁻³ m/s]"; no brackets if there is neither unit nor exponent.
std::string axisTitle(const std::string& name, const std::string& unit, int exponent);

/// A unit of the field table in `dimension` dimensions: "kg/m^d" in 2-D is "kg/m²".
std::string unitIn(std::string_view unit, int dimension);

}  // namespace plenum
