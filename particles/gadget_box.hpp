// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/scene.hpp"

#include <array>
#include <vector>

namespace plenum {

/// The box of GADGET and SWIFT: coordinates stand in [0, size) on three axes.
struct GadgetBox {
  std::array<double, 3> size{};   ///< [m], positive
  std::array<double, 3> shift{};  ///< scene coordinate + shift = file coordinate [m]
};

/// Along periodic axes the domain's period; along open ones room for all particles and, beyond
/// them, a kernel's support, so that a reader who takes every axis as periodic finds no neighbour
/// across the seam. Axes that the scene does not have are as long as its longest one. An axis is
/// shifted only if particles leave [0, size).
template <int Dim>
GadgetBox gadgetBox(const Scene<Dim>& scene);

/// Rows (x, y, z) in the box. `changed` tells whether any coordinate differs from the scene's.
template <int Dim>
std::vector<double> gadgetCoordinates(const Scene<Dim>& scene, const GadgetBox& box, bool& changed);

}  // namespace plenum
