// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"

namespace plenum {

/// Ordered pairs (i, j), i != j, within the support, which may be one of i: what the sums of i run
/// over.
struct Interactions {
  double all = 0;       ///< i is any particle that receives sums
  double ofFluids = 0;  ///< i is fluid
};

/// Counts them with a term of the engine that adds 1 a neighbour, at the positions of the last
/// update(); walls count as receivers where `wallsReceive`.
template <int Dim>
Interactions countInteractions(Engine<Dim>& engine, const ParticleSet<Dim>& particles,
                               bool wallsReceive);

}  // namespace plenum
