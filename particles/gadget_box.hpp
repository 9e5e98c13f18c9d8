// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/scene.hpp"

#include <array>
#include <cstddef>
#include <span>

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

/// Rows (x, y, z) in the box of the particles from `first` on, as many as `rows` has room for.
template <int Dim>
void gadgetCoordinates(std::span<const Vec<Dim>> positions, const GadgetBox& box, std::size_t first,
                       std::span<double> rows);

/// Whether any coordinate in the box differs from the scene's.
template <int Dim>
bool changesCoordinates(std::span<const Vec<Dim>> positions, const GadgetBox& box);

}  // namespace plenum
