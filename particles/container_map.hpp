// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace plenum {

/// The region in which fluid may be, as a signed distance sampled on a grid of cell centres: all
/// that the solver knows of the geometry. It answers "has this particle left?" and "does this point
/// count as a hole?" without CGAL or gmsh.
///
/// A sample is one signed byte in steps of `step` [m], negative inside, clipped at +-127 steps.
/// An empty map stands for "everywhere inside the domain".
template <int Dim>
struct ContainerMap {
  Vec<Dim> lower{};                 ///< lower corner of the grid [m]
  double spacing = 0;               ///< edge of a grid cell [m]
  double step = 0;                  ///< signed distance of one count [m]
  std::array<int, Dim> shape{};     ///< cells per axis; the first axis varies fastest
  std::vector<std::int8_t> counts;  ///< length product of shape

  bool empty() const { return counts.empty(); }

  /// Signed distance [m] at x, linear between samples; beyond the grid the clipped maximum, in an
  /// empty map minus infinity.
  double signedDistance(const Vec<Dim>& x) const;

  Box<Dim> bounds() const;
};

extern template struct ContainerMap<1>;
extern template struct ContainerMap<2>;
extern template struct ContainerMap<3>;

}  // namespace plenum
