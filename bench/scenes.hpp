// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "particles/scene.hpp"

namespace plenum::bench {

/// What a Simulation is made of. d_ref = 1 m and c = 100 m/s in all scenes; wendland_c2, in liquids
/// with 33 neighbours in 2-D and about 97 in 3-D, in the ideal gas with 23 and 57.
template <int Dim>
struct Setup {
  Scene<Dim> scene;
  SolverSettings settings;
  double height = 0;  ///< of the water at the start [m]
};

/// About `n` particles of water, a column twice as high as wide in 2-D and a cube in 3-D, in an
/// open tank three times (3-D: twice) as long: a hexagonal or hcp lattice at rest with the density
/// of the hydrostatic pressure. Gravity makes c = 10 sqrt(2 g H). Continuity, pressure, Monaghan's
/// viscosity; density and pressure of walls follow the fluid's equations.
template <int Dim>
Setup<Dim> damBreakAtRest(std::size_t n);

/// The same as it looks when it flows: lattice and velocities in disorder, moving down and out at
/// up to c/10. Stands for the running dam break where that would take hours to reach.
template <int Dim>
Setup<Dim> damBreakMade(std::size_t n);

/// A gas at rest but for sound, in a periodic box; density by summation.
template <int Dim>
Setup<Dim> quietGas(std::size_t n);

/// An ideal gas with sheared motion of .3 c in a periodic box: smoothing lengths by iteration,
/// grad-h forces, energy equation, Monaghan's viscosity with beta, kick-drift-kick.
template <int Dim>
Setup<Dim> idealGas(std::size_t n);

}  // namespace plenum::bench
