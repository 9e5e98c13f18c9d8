// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study stability interface: how methods stand a ratio of densities.
#pragma once

#include "particles/scene.hpp"
#include "studies/maps/map_files.hpp"

#include <string>
#include <vector>

namespace plenum::study {

struct InterfaceOptions {
  MapOptions common;
  std::vector<double> ratios{1, 3, 10, 30, 100, 300, 1000};  ///< of densities
  std::vector<std::string> methods;                          ///< empty: all
};

/// The names that `methods` may have.
std::vector<std::string> interfaceMethods();

/// How far two fluids that lie on each other are apart [d_ref]: over columns two d_ref wide, the
/// median of the lowest particle of material 1 over the highest of material 0. Between rows of a
/// hexagonal lattice .866; negative where they mix. Columns that lack one of them do not count; NaN
/// if none has both.
double interfaceGap(const Scene<2>& scene);

/// Throws InputError, before anything runs, for options that cannot be used.
void runInterface(InterfaceOptions options);

}  // namespace plenum::study
