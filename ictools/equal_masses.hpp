// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"

namespace plenum {

/// The fluid that `equal_mass_with` names.
template <int Dim>
const FluidFill<Dim>& equalMassPartner(const std::vector<FluidFill<Dim>>& fluids,
                                       const FluidFill<Dim>& fluid);

/// Gives each fluid that says `equal_mass_with` a lattice whose cells hold the mass of the other
/// one's cells (fitted to periods as they are). It is not fitted itself: a blob in a tunnel touches
/// no periodic face.
template <int Dim>
void matchMasses(std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame);

}  // namespace plenum
