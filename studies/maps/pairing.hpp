// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-study stability pairing: which kernels let particles pair, at which smoothing lengths.
#pragma once

#include "studies/maps/map_files.hpp"

#include <optional>
#include <string>
#include <vector>

namespace plenum::study {

struct PairingOptions {
  MapOptions common;
  int dimension = 2;
  std::string start = "random";      ///< "random", or "noise": a lattice with 2 % of noise
  std::vector<std::string> kernels;  ///< empty: all
  std::vector<double> lengths;       ///< h/d_ref
  std::vector<double> neighbours;    ///< in the support, instead of lengths
  std::optional<int> seeds;
};

/// h/d_ref at which a kernel's support 2h has N_H neighbours on the lattice of nearest-neighbour
/// distance d_ref: hexagonal in 2-D, hcp in 3-D. N_H counts the particle itself:
/// N_H = V_d (2h)^d n with V_2 = pi, V_3 = 4 pi/3 and n particles in a unit of volume.
double lengthOfNeighbours(double neighbours, int dimension);

/// Throws InputError, before anything runs, for options that cannot be used.
void runPairing(PairingOptions options);

}  // namespace plenum::study
