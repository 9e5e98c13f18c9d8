// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/fluids.hpp"
#include "ictools/wall_layers.hpp"
#include "particles/scene.hpp"

#include <filesystem>
#include <vector>

namespace plenum {

/// A wall with its particles.
template <int Dim>
struct WallFill {
  WallSettings settings;
  WallSolid<Dim> solid;
  Lattice<Dim> lattice;  ///< continued behind the surface by method "lattice"
  double spacing = 0;    ///< of its layers [m]
  double support = 0;    ///< largest of the kernels that meet it [m]
  int layers = 0;
  double thickness = 0;  ///< from the surface to the last layer, or through the solid [m]
  double density = 0;    ///< reference [kg/m^d]
  RigidMotion motion = {};
  std::vector<WallPoint<Dim>> points = {};
};

/// Layers of this spacing that cover a support [m], rounded up.
int layersNeeded(double support, double spacing);

/// Checks a wall; `fluids` are prepared. Where they are refined it gets the finest spacing along
/// its surface, and is as thick as the largest kernel that meets it. Throws InputError for an
/// unknown `lattice_of` and as `rigidMotion` does, which reads files in `folder`. Warns of a wall
/// thinner than the kernel's support.
template <int Dim>
WallFill<Dim> prepareWall(const WallSettings& settings, GeometryPtr<Dim> geometry,
                          const std::vector<FluidFill<Dim>>& fluids, const SceneFrame<Dim>& frame,
                          const std::filesystem::path& folder, const Warn& warn);

/// Throws FaultyInput, with count, place and remedy for each pair, if particles of a fluid stand in
/// the solid of a wall.
template <int Dim>
void checkFluidOutsideWalls(const std::vector<FluidFill<Dim>>& fluids,
                            const std::vector<WallFill<Dim>>& walls, const SceneFrame<Dim>& frame);

/// Where wall particles may be: the bounds of fluids, enclosed regions, finite solids and
/// `container`, grown by the thickest wall.
template <int Dim>
Box<Dim> wallBox(const std::vector<WallFill<Dim>>& walls, const std::vector<FluidFill<Dim>>& fluids,
                 const Box<Dim>& container, const SceneFrame<Dim>& frame);

/// Puts particles into all walls. Where the layers of two walls overlap (corners), the first wall
/// has the place; a particle of a later wall nearer than 0.6 of its spacing to one of an earlier
/// wall is left out. Infinite solids end where nothing else of the scene is: at the bounds of
/// fluids, enclosed regions, finite solids and `container`, grown by the thickest wall. Throws
/// InputError for a wall that gets no particle.
template <int Dim>
void fillWalls(std::vector<WallFill<Dim>>& walls, const std::vector<FluidFill<Dim>>& fluids,
               const Box<Dim>& container, const SceneFrame<Dim>& frame);

}  // namespace plenum
