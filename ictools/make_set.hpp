// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands of plenum-ic that make particle sets. Each returns the exit code.
#pragma once

#include "ictools/options.hpp"

#include <filesystem>

namespace plenum {

/// From a case to a particle file with its report card.
int runGenerate(const Options& options);

/// As `generate`, with relaxation whether the case asks for it or not; or from a particle file that
/// plenum-ic made: particles go on from where they stand in it.
int runRelax(const Options& options);

/// A picture of a particle file, or of what a case makes.
int runPreview(const Options& options);

}  // namespace plenum
