// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a case will cost, before it is paid.
#pragma once

#include "ictools/walls.hpp"

#include <string>

namespace plenum {

/// Particles of a case, counted or expected, and what they cost.
struct Estimate {
  double nFluid = 0;
  double nWalls = 0;
  bool isCounted = false;     ///< false: volume over the lattice's cell
  double neighbours = 0;      ///< in the kernel's support
  double generateMemory = 0;  ///< [bytes]
  double runMemory = 0;       ///< [bytes]
  double stepTime = 0;        ///< of one thread [s]
};

/// Fluid particles by the estimates that `countExpected` made.
template <int Dim>
double expectedFluid(const std::vector<FluidFill<Dim>>& fluids);

/// Wall particles by the volume of the layers in `box`; to some percent.
template <int Dim>
double expectedWalls(const std::vector<WallFill<Dim>>& walls, const Box<Dim>& box);

/// Memory and time of a run from the numbers of particles. Memory as measured on boxes of 2e5 to
/// 5e6 particles, a step by the 4 ns an interaction of docs/benchmarks.md (mixed precision, AVX2,
/// one thread): another machine or scene may take half or twice as much. Neighbours are those in
/// the first fluid.
template <int Dim>
Estimate estimateOf(double nFluid, double nWalls, bool isCounted, const FluidFill<Dim>& first,
                    const SceneFrame<Dim>& frame);

/// Bytes that making the set needs, by the expected number of fluid particles.
template <int Dim>
double memoryToGenerate(const std::vector<FluidFill<Dim>>& fluids, double nWalls);

/// Throws InputError, before memory is asked for, if the particles of the fluids need more of it
/// than the machine has to spare.
template <int Dim>
void checkMemory(const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame);

/// Some lines for the terminal.
std::string describe(const Estimate& estimate);

}  // namespace plenum
