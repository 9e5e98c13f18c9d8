// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/instruction_set.hpp"

namespace plenum::bench {

/// Independent sums that the loop keeps in registers: as many as hide the latency of a
/// multiply-add, and no more than 16 registers hold.
constexpr int nChains = 12;

/// `rounds` multiply-adds in each lane of `nChains` packs as wide as a register of `Isa`
/// (peak_loop.cpp, compiled like the pair loops); returns their sum.
template <class Isa, class T>
T multiplyAdds(long rounds);

/// Gflop/s of `threads` threads that do nothing but multiply-adds with the instruction set of the
/// pair loops: an upper bound of what they can reach. CPU time for one thread, wall time for more.
double peakGflops(bool inDouble, int threads);

}  // namespace plenum::bench
