// SPDX-License-Identifier: GPL-3.0-or-later
//
// From particles to a grid of pixels by their kernels. Only particles/*.cpp include this.
#pragma once

#include "particles/box.hpp"
#include "particles/kernels.hpp"
#include "particles/particle_set.hpp"
#include "particles/picture_frame.hpp"

#include <optional>
#include <span>
#include <vector>

namespace plenum {

/// What to sum over the pixels of a plane. The plane has the axes `horizontal` and `vertical`; in
/// 3-D the third axis is cut or looked along.
template <int Dim>
struct MapPlane {
  PlaneView view;  ///< [m]
  int width = 1;   ///< pixels along the horizontal axis; their height is their width
  int horizontal = 0;
  int vertical = 1;
  std::optional<double> cut = {};  ///< in 3-D, where the plane stands [m]; absent: whole columns

  int height() const;
};

/// Kernel, support and periods of the particles.
template <int Dim>
struct MapKernel {
  KernelId kernel;
  double smoothingLength = 0;  ///< of particles that have none of their own [m]
  Box<Dim> domain;             ///< periodic axes continue the plane
};

/// Numbers of pixels, row by row from the bottom.
struct PixelMap {
  int width = 0;
  int height = 0;
  std::vector<double> values;  ///< NaN where no kernel reaches

  double at(int column, int row) const {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
};

/// The density of the fluids: sum_j m_j W(r - r_j, h_j) in a plane [kg m^-d], or along a column its
/// integral, sum_j m_j int W dz [kg m^-2]. A column's mass is that of its particles to rounding
/// where the plane holds them whole: kernels of few pixels are normalized on the pixels. Price
/// 2007, doi 10.1071/AS07022.
template <int Dim>
PixelMap densityMap(const ParticleSet<Dim>& particles, const MapPlane<Dim>& plane,
                    const MapKernel<Dim>& kernel);

/// The mean of numbers that the fluids have: in a plane sum_j (m_j/rho_j) A_j W / sum_j (m_j/rho_j)
/// W, along a column weighted by mass. `numbers` has length nFluid.
template <int Dim>
PixelMap meanMap(const ParticleSet<Dim>& particles, std::span<const double> numbers,
                 const MapPlane<Dim>& plane, const MapKernel<Dim>& kernel);

}  // namespace plenum
