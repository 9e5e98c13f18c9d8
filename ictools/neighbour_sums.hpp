// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/engine.hpp"
#include "particles/kernels.hpp"

namespace plenum {

/// Sums over neighbours that making and judging a particle set needs.
enum class NeighbourSum {
  kernelSum,  ///< field::kernelSum
  pressure,   ///< field::force by field::volume and field::pressure
  voronoi,    ///< field::push; needs a smoothing length of each particle
  quality     ///< field::density by mass, field::kernelSum and field::kernelGradient; in double
};

/// With one smoothing length [m], or with those of the particles.
struct Smoothing {
  KernelId kernel;
  double length = 0;      ///< of all [m]; unused if each has its own
  bool adaptive = false;  ///< each has its own: field::smoothingLength
};

/// The pass of a sum for an engine that computes in `units`; fluids receive, or all. The loops of
/// wendland_c2 are tuned, other kernels share generic ones. `voronoi` and `quality` need smoothing
/// lengths of the particles.
template <int Dim>
PairPass<Dim> neighbourPass(NeighbourSum sum, const Smoothing& smoothing, const Units& units,
                            Group receivers = Group::fluids);

}  // namespace plenum
