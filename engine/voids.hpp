// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/scene.hpp"

namespace plenum {

/// void1: share of the points of a grid (spacing d_ref/3) in the container that are further than
/// d_ref from any particle, walls included. With a free surface only those points count that have
/// particles within 2 d_ref in all quadrants (octants in 3-D). The container moves with the walls,
/// if all of them move as one. The same bits for any number of threads.
template <int Dim>
double measureVoids(const ParticleSet<Dim>& particles, const SceneInfo<Dim>& info,
                    bool freeSurface);

}  // namespace plenum
