// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/kernel_transform.hpp"

#include <optional>
#include <string>

namespace plenum {

/// What is known of pairing for a kernel at a density of neighbours.
struct PairingForecast {
  enum class Verdict {
    safe,      ///< the transform is nowhere negative: no measured set paired
    pairs,     ///< measured sets paired
    unpaired,  ///< the transform turns negative, but measured sets with so few neighbours stayed
               ///< even
    unknown    ///< it turns negative, and nobody measured
  };
  Verdict verdict = Verdict::unknown;
  TransformSign transform;
  double neighbours = 0;                ///< within the support, at this h and spacing
  std::optional<double> measuredShare;  ///< f.5 of measured sets from random starts, interpolated
  std::string text;                     ///< one line for people
};

/// For a kernel with smoothing length `h` [m] among particles of mean volume `volume` [m^d]. The
/// sign of the kernel's transform says whether pairing can gain at all; measured shares of paired
/// particles (gas boxes from random starts, docs/initial_conditions.md) say whether it sets in at
/// so many neighbours. Neither alone would do.
PairingForecast forecastPairing(KernelId kernel, int dimension, double h, double volume);

}  // namespace plenum
