// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study stability collisions: how far and how hard particles should collide.
#pragma once

#include "studies/maps/map_files.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

struct CollisionOptions {
  MapOptions common;
  std::string kernel = "wendland_c2_1d";
  std::vector<double> ranges{0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 1.0, 1.1};  ///< delta_c [d_ref]
  std::vector<double> restitutions{0.01, 0.25, 0.5, 0.75, 1};                 ///< C_R
  std::optional<int> seeds;
};

/// Throws InputError, before anything runs, for options that cannot be used.
void runCollisions(const CollisionOptions& options);

}  // namespace plenum::study
