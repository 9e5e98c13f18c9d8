// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"
#include "ictools/random.hpp"

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

/// Fills a fluid that has a profile with particles of equal mass, that of a lattice cell at the
/// reference density: as many as the mass in the region asks for, at random places whose density is
/// that of the profile. Places are drawn one for each particle's share of the mass along the rows
/// of a fine lattice, so that there are no more and no fewer than there should be in any larger
/// part of the region. Sets `points` and `particleMass`; the sum of masses is the profile's
/// integral by that lattice. Throws InputError where the profile is not positive, or if it asks for
/// more than 2^31 particles or a lattice of more than 4e8 points.
template <int Dim>
void fillWithEqualMasses(FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame, Random random);

/// Volume that each of a fluid's particles is meant to have at `points` [m^d]: that of the density
/// averaged over about a spacing.
template <int Dim>
std::vector<double> targetVolumes(const FluidFill<Dim>& fluid, std::span<const Vec<Dim>> points,
                                  const Box<Dim>& domain);

}  // namespace plenum
