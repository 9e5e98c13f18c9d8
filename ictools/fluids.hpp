// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "ictools/density_profile.hpp"
#include "ictools/fill.hpp"
#include "ictools/ic_settings.hpp"
#include "ictools/resolution.hpp"
#include "ictools/scene_frame.hpp"

#include <vector>

namespace plenum {

/// A fluid with the places of its particles.
template <int Dim>
struct FluidFill {
  FluidSettings settings;
  GeometryPtr<Dim> region;  ///< null: the whole periodic domain
  Box<Dim> box;             ///< that contains it; periodic axes as in the domain
  Lattice<Dim> lattice;     ///< for `random` the closest packing that it has the density of
  DensityProfilePtr<Dim> profile = {};  ///< null: the same density everywhere
  ResolutionPtr<Dim> resolution = {};   ///< null: nothing is refined
  std::vector<Vec<Dim>> points = {};
  Measure volume = {};         ///< of the region [m^d]
  double expected = 0;         ///< number of particles, estimated before there are any
  double finest = 1;           ///< spacing where it is finest, over that of the lattice; estimated
  double particleVolume = 0;   ///< [m^d]; of particles of equal mass that of the mean, of a refined
                               ///< fluid that where it is not refined
  double particleMass = 0;     ///< of all particles of a profile with equal masses [kg]
  double volumeFactor = 1;     ///< of a refined fluid's volumes, for a whole number of particles
  std::size_t nCovered = 0;    ///< places left to an earlier fluid
  std::size_t nParticles = 0;  ///< counted when `assemble` takes the points
  double lengthScale = 1;      ///< of its spacing and smoothing length over those of the scene
  bool isPlaced = false;       ///< the points are given, by a file or an earlier set
  bool isCut = false;          ///< the region reaches beyond periodic faces

  /// Particles have different volumes.
  bool spacingVaries() const { return resolution || settings.spacingFollowsDensity(); }

  /// Puts the lattice where the settings want it, or by the half-spacing rule.
  void placeLattice();

  /// That a particle has if the fluid fills what is its own [m^d].
  double meanVolume() const {
    const bool ownsRegion = nCovered == 0 && !isCut;
    return ownsRegion ? volume.value / static_cast<double>(points.size()) : lattice.cellVolume();
  }
};

/// The fluid's lattice with another d_ref [m], with the same origin.
template <int Dim>
Lattice<Dim> latticeWith(const FluidFill<Dim>& fluid, double spacing, const SceneFrame<Dim>& frame);

/// Checks a fluid and sets up its lattice: fitted to periodic axes, at its origin or by the
/// half-spacing rule. Throws InputError for a region that is infinite, empty, or holds more than
/// 2^31 particles.
template <int Dim>
FluidFill<Dim> prepareFluid(const FluidSettings& settings, GeometryPtr<Dim> region,
                            DensityProfilePtr<Dim> profile, const SceneFrame<Dim>& frame,
                            const Warn& warn);

/// Puts particles into all fluids. A fluid has the lattice points inside its region and outside of
/// the regions of earlier fluids. A point on the surface (fill.hpp) is left out, unless fluid lies
/// all around it: on the face between two fluids (the first one has it) or on a periodic face.
/// A fluid whose spacing varies is filled by `fillByNumberDensity`, one that is placed keeps its
/// points. `random`: as many points as the closest packing has in the region's volume, uniform,
/// seeded. Throws InputError for a region that gets no particle.
template <int Dim>
void fillFluids(std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame);

/// Particles of a fluid, or of all, in one list.
template <int Dim>
std::vector<Vec<Dim>> allPoints(const std::vector<FluidFill<Dim>>& fluids);

}  // namespace plenum
