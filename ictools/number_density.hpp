// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fluids whose particles do not all have the same volume: 1/V is their number density.
#pragma once

#include "ictools/fluids.hpp"
#include "ictools/random.hpp"

#include <span>
#include <vector>

namespace plenum {

/// Estimates how many particles each fluid will have, to about a percent, without placing any:
/// the integral of the number density, or volume over the lattice's cell. Sets `expected` and
/// `finest`. Throws InputError where a profile is not positive, and if there are more than 2^31
/// particles. Warns of refinements that touch no fluid.
template <int Dim>
void countExpected(std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame,
                   const Warn& warn);

/// Fills a fluid that has a profile with equal masses, or that is refined: as many particles as the
/// integral of the number density asks for. The region is cut into cells finer than the spacing,
/// these are put in a row along Hilbert's curve, and the row is divided into shares of one particle
/// each. It stands in the middle of its share, or at random in it if the lattice is `random`.
/// Sets `points`, and `particleMass` or `volumeFactor`; the sum of the masses is the profile's
/// integral by the cells. Throws InputError where the profile is not positive. `countExpected` was
/// called.
template <int Dim>
void fillByNumberDensity(FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame, Random random);

/// Sets only the share of a particle, as `fillByNumberDensity` does: for a fluid whose places are
/// given.
template <int Dim>
void setShares(FluidFill<Dim>& fluid, const SceneFrame<Dim>& frame);

/// Volume that each of a fluid's particles is meant to have at `points` [m^d]; where a profile
/// jumps, that of the density averaged over about a spacing.
template <int Dim>
std::vector<double> targetVolumes(const FluidFill<Dim>& fluid, std::span<const Vec<Dim>> points,
                                  const Box<Dim>& domain);

}  // namespace plenum
