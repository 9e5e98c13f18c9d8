// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"
#include "ictools/walls.hpp"

#include <memory>
#include <span>
#include <vector>

namespace plenum {

/// Where the states of some particles go, one number a particle each.
struct StateArrays {
  std::span<double> density;         ///< [kg/m^d]
  std::span<double> pressure;        ///< [Pa m^(3-d)]
  std::span<double> internalEnergy;  ///< [J/kg]; empty unless the fluid is an ideal gas
};

/// What the particles of a fluid or a wall start with. There is one for each equation of state:
/// in a liquid the density follows from the pressure, in a gas it is the one given.
template <int Dim>
class InitialStates {
 public:
  virtual ~InitialStates() = default;

  /// States at `points` [m]. Throws InputError, with the place, where there is none.
  virtual void at(std::span<const Vec<Dim>> points, const StateArrays& states) const = 0;
};

template <int Dim>
using InitialStatesPtr = std::unique_ptr<const InitialStates<Dim>>;

/// Of the particles of a fluid; its profile, if any, gives the densities of a gas.
template <int Dim>
InitialStatesPtr<Dim> initialStates(const FluidFill<Dim>& fluid, const SolverSettings& solver);

/// Of a wall, whose equation of state is that of the fluid whose density it has. Walls of
/// solver.wall_pressure = "zero" have none unless they name one.
template <int Dim>
InitialStatesPtr<Dim> initialStates(const WallFill<Dim>& wall,
                                    const std::vector<FluidFill<Dim>>& fluids,
                                    const SolverSettings& solver);

}  // namespace plenum
