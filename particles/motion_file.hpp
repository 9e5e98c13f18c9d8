// SPDX-License-Identifier: GPL-3.0-or-later
//
// Harmonic and tabulated motions in /Plenum/Walls. Only particles/*.cpp include this.
#pragma once

#include "particles/hdf5.hpp"
#include "particles/scene.hpp"

#include <vector>

namespace plenum {

/// Writes nothing but what some wall has.
void writeMotions(const hdf5::Group& group, const std::vector<Wall>& walls);

/// Adds what the file has to the motions of its walls; datasets that are missing mean that no wall
/// has such a motion. Throws InputError for wrong lengths and motions without sense.
void readMotions(const hdf5::Group& group, std::vector<Wall>& walls);

}  // namespace plenum
