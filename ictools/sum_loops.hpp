// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/tile_work.hpp"
#include "ictools/neighbour_sums.hpp"

namespace plenum {

/// What a loop was chosen for.
struct SumChoice {
  NeighbourSum sum;
  Smoothing smoothing;  ///< its length in the engine's units
};

/// The loop for a choice, compiled for the instruction set `Isa` (sum_loops.cpp); null where there
/// is none.
template <class Isa, class T, int Dim>
TileFunction<Dim, T> sumFunction(const SumChoice& choice);

}  // namespace plenum
