// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is measured of a state. The definitions are the same everywhere: history.csv,
// summary.json, charts and tests.
#pragma once

#include "particles/scene.hpp"

#include <span>
#include <vector>

namespace plenum {

/// Order of the fluid particles. Distances are to the nearest other fluid particle, in units of
/// d_ref; a particle that has none within 2.5 d_ref counts as 2.5.
struct SpacingMeasures {
  double minNearest = 0;   ///< min nn
  double meanNearest = 0;  ///< mean nn
  double below01 = 0;      ///< f.1: share of particles with nn < 0.1
  double below05 = 0;      ///< f.5
  double below085 = 0;     ///< f.85
  double psi6 = 0;         ///< mean |psi_6| over the six nearest neighbours, 2-D only
};

template <int Dim>
SpacingMeasures measureSpacing(const ParticleSet<Dim>& particles, const Box<Dim>& domain,
                               double spacing);

/// What a fluid particle has around it, walls included.
struct Neighbourhood {
  double nearest = 0;  ///< distance to the nearest particle, in the mean of both spacings; 2.5:
                       ///< none so near
  double bondOrder =
      0;  ///< |psi_6| over six neighbours in 2-D (1: hexagonal), q_6 over twelve in 3-D
          ///< (hcp .485, fcc .575, random about .29); NaN where there are fewer, and in 1-D
};

/// Neighbourhoods of all fluid particles; spacing[i] is the distance at which particle i is meant
/// to have its neighbours [m], length size(). q_6: Steinhardt et al. 1983,
/// doi 10.1103/PhysRevB.28.784.
template <int Dim>
std::vector<Neighbourhood> neighbourhoods(const ParticleSet<Dim>& particles, const Box<Dim>& domain,
                                          std::span<const double> spacing);

/// The container moves with the walls, if all of them move as one.
///
/// Fluid particles further than d_ref/2 outside the container.
template <int Dim>
std::size_t countLeft(const ParticleSet<Dim>& particles, const SceneInfo<Dim>& info);

/// Fluid particles outside of the domain along its open axes: the box around all particles of the
/// set, walls included, as it was made. Who is there went through the walls.
template <int Dim>
std::size_t countEscaped(const ParticleSet<Dim>& particles, const SceneInfo<Dim>& info);

}  // namespace plenum
