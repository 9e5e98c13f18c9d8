// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "particles/scene.hpp"

namespace plenum::bench {

/// Water that collapses in an open tank, walls on the floor and at the sides: a lattice (hexagonal
/// or hcp) that has begun to deform, with about `n` fluid particles. d_ref = 1 m, c = 100 m/s,
/// speeds up to about c/10.
template <int Dim>
Scene<Dim> damBreak(std::size_t n, double support);
SolverSettings damBreakSettings(int dim);

/// A gas at rest but for sound, in a periodic box.
template <int Dim>
Scene<Dim> quietGas(std::size_t n);
SolverSettings quietGasSettings(int dim);

}  // namespace plenum::bench
