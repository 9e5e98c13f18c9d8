// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/pair_pass.hpp"
#include "engine/units.hpp"
#include "particles/case_settings.hpp"
#include "solver/phases.hpp"

#include <array>
#include <string>
#include <type_traits>

namespace plenum {

/// Whether there are loops for a number type: 1-D scenes are small, they compute in double only.
template <int Dim, class T>
inline constexpr bool hasLoops = Dim > 1 || std::is_same_v<T, double>;

/// The passes of a step, as the case asks for them; empty where the scene does not model it.
template <int Dim>
struct StepPasses {
  PairPass<Dim> densityGradient;  ///< writes densityGradient and moments, for `density`
  PairPass<Dim> density;          ///< writes density or velocityDivergence
  PairPass<Dim> densityAtWalls;   ///< writes the rest of it, where `density` is of fluids alone
  PairPass<Dim> atWalls;          ///< writes what is before the walls
  PairPass<Dim> densityMoment;    ///< writes densityMoment, for the mean density
  PairPass<Dim> convergence;      ///< writes densityRate and velocityCurl, before `forces`
  PairPass<Dim> forces;           ///< writes force; in a gas densityRate and power, too
  PairPass<Dim> collisions;       ///< writes impulse
  PairPass<Dim> concentration;    ///< writes kernelGradient and positionDivergence

  std::array<const PairPass<Dim>*, 9> all() const {
    return {&densityGradient, &density, &densityAtWalls, &atWalls,      &densityMoment,
            &convergence,     &forces,  &collisions,     &concentration};
  }
};

/// What passes depend on beside the settings.
struct PassOptions {
  double spacing = 0;  ///< d_ref [m]
  bool hasWalls = false;
  bool measuresLoads = false;  ///< forces and impulses on walls are summed, too
};

/// `units` are those of the engine. Kernels in the scenes' list get a loop of their own; the others
/// share one loop that chooses the kernel at run time.
template <int Dim>
StepPasses<Dim> selectPasses(const SolverSettings& settings, const Phases& phases,
                             const PassOptions& options, const Units& units);

/// Momentum form with "matching" resolved.
std::string momentumForm(const SolverSettings& settings);

}  // namespace plenum
