// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/pair_pass.hpp"
#include "engine/units.hpp"
#include "particles/case_settings.hpp"

#include <string>

namespace plenum {

/// The passes of a step, as the case asks for them; empty where the scene does not model it.
template <int Dim>
struct StepPasses {
  PairPass<Dim> density;     ///< writes density or velocityDivergence
  PairPass<Dim> forces;      ///< writes force
  PairPass<Dim> collisions;  ///< writes impulse
};

/// `spacing` is d_ref [m], `units` are those of the engine. Kernels in the scenes' list get a loop
/// of their own; the others share one loop that chooses the kernel at run time.
template <int Dim>
StepPasses<Dim> selectPasses(const SolverSettings& settings, double spacing, bool hasWalls,
                             const Units& units);

/// Momentum form with "matching" resolved.
std::string momentumForm(const SolverSettings& settings);

}  // namespace plenum
