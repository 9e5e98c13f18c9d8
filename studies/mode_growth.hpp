// SPDX-License-Identifier: GPL-3.0-or-later
//
// The solver held to linear theory: a perfect periodic lattice, displaced by one of its waves.
#pragma once

#include "studies/lattice_modes.hpp"

#include <array>
#include <string>
#include <vector>

namespace plenum::study {

/// How the solver moved a wave.
struct MeasuredMode {
  LatticeState state;
  std::array<int, 3> waves{};  ///< in the box along each axis
  std::size_t branch = 0;
  double omegaSquared = 0;  ///< of linear theory [c^2/d_ref^2]
  double measured = 0;      ///< omega^2 of the solver
  double longitudinal = 0;  ///< 0 transverse, 1 longitudinal

  /// Of the frequency, or of the growth rate, relative.
  double deviation() const;
};

/// Runs the solver (2.2)/(2.3), without viscosity, pairs in double, on a periodic box of `nCells`
/// cells an axis, displaced by 1e-6 d_ref along the wave. A stable wave swings as cos(omega t): its
/// frequency follows from the time of its zeros. An unstable one grows as cosh(s t). Throws
/// InputError for a box narrower than the solver takes.
template <int Dim>
MeasuredMode measureMode(const LatticeState& state, int nCells, const std::array<int, 3>& waves,
                         std::size_t branch);

/// Of all waves of such a box the one that grows fastest, and the one that swings fastest,
/// measured.
template <int Dim>
std::vector<MeasuredMode> measureExtremes(const LatticeState& state, int nCells);

std::string tableOf(const std::vector<MeasuredMode>& modes);
std::string csvOf(const std::vector<MeasuredMode>& modes);

}  // namespace plenum::study
