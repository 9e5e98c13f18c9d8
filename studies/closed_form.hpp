// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"

#include <optional>
#include <string>

namespace plenum::study {

/// The error of the pressure gradient of a column of water at rest, as the discrete equations have
/// it on their lattice [%]: (1/M)(1 + g H/(2 c^2)) - 1 with the lattice moment
/// M = -sum_j V y_j^2 W'(r_j)/r_j. It depends on kernel and h/d_ref, not on the spacing.
/// ([C] table 1, doi 10.4236/jamp.2018.69158.)
class HydrostaticColumn {
 public:
  /// None if the case is no such column: 2-D, on a square or hexagonal lattice, that measures its
  /// pressure gradient under gravity.
  static std::optional<HydrostaticColumn> of(const CaseSettings& settings);

  double error(const std::string& kernel, double smoothingLengthOverSpacing) const;

 private:
  double compression_ = 0;  // g H/(2 c^2)
  bool isHexagonal_ = true;
};

}  // namespace plenum::study
