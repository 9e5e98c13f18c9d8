// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study stability tension: where particles clump because the pressure is negative.
#pragma once

#include "studies/maps/map_files.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

struct TensionOptions {
  MapOptions common;
  std::string kernel = "wendland_c2";
  std::vector<double> pressures{-1, -0.3, -0.1, -0.03, -0.01, 0, 0.01, 0.1, 1};  ///< p0/(rho c^2)
  std::vector<double> lengths{1.2, 1.5, 2, 2.5, 3};                              ///< h/d_ref
  std::optional<int> seeds;
};

/// Throws InputError, before anything runs, for options that cannot be used.
void runTension(const TensionOptions& options);

}  // namespace plenum::study
