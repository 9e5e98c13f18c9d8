// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study stability modes: the wave of a lattice that grows fastest, by kernel, background
// pressure and smoothing length. A growing wave means that the lattice leaves its place; whether it
// pairs or becomes another lattice is for stability pairing to say.
#pragma once

#include "particles/kernels.hpp"
#include "studies/chart.hpp"

#include <string>
#include <vector>

namespace plenum::study {

struct ModeCell {
  double omegaSquared = 0;  ///< lowest [c^2/d_ref^2]
  double wavelength = 0;    ///< [d_ref]
  double longitudinal = 0;  ///< 0 transverse, 1 longitudinal
};

struct ModeRow {
  KernelId kernel;
  double backgroundPressure = 1;  ///< p0 [rho0 c^2]
  std::vector<ModeCell> cells;    ///< by smoothing length
};

struct ModeMap {
  std::string lattice;
  std::vector<double> smoothingLengths;  ///< h/d_ref
  std::vector<ModeRow> rows;             ///< kernel by kernel, and pressure by pressure within
};

/// Throws InputError for unknown kernels and lattices.
ModeMap computeModes(const std::string& lattice, const std::vector<double>& backgroundPressures,
                     const std::vector<std::string>& kernels,
                     const std::vector<double>& smoothingLengths);

/// Growth rates sqrt(-omega^2), 0 where all waves are stable.
HeatMap heatMapOf(const ModeMap& map);
std::string tableOf(const ModeMap& map);
std::string csvOf(const ModeMap& map);

}  // namespace plenum::study
