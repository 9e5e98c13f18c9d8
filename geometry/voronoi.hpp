// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"

#include <span>
#include <vector>

namespace plenum {

/// Points whose Voronoi cells are wanted, and those that bound these cells.
template <int Dim>
struct Generators {
  std::span<const Vec<Dim>> points;         ///< [m]
  std::size_t n = 0;                        ///< the first n are wanted
  std::span<const double> logWeights = {};  ///< ln w at each point; empty: w = 1 everywhere
};

/// The part of space that is nearer to its generator than to any other.
template <int Dim>
struct VoronoiCell {
  Vec<Dim> centroid;  ///< int w x dV / int w dV [m]
  double volume = 0;  ///< int dV, without the weight [m^d]
};

/// Cells of the first n generators (length n). Of generators at the same place one has the cell,
/// the others have no volume and themselves as centroid.
///
/// Generators at the centroids of their cells stand with a density proportional to w^(d/(d+2))
/// (Du, Faber, Gunzburger 1999, doi 10.1137/S0036144599352836): for the density rho,
/// w = rho^((d+2)/d). Within a cell ln w goes on linearly from its generator with the gradient of
/// Springel 2010, doi 10.1111/j.1365-2966.2009.15715.x, eq. (21), but never beyond what the
/// neighbours have; so weights may differ by any factor. Integrals are those of w linear on the
/// simplices between generator and facets. Only ratios of weights matter.
///
/// `box`: along its periodic axes points repeat, and must lie within; other axes do not matter.
/// Images within `margin` [m] of periodic faces are added; if that is too little for some cell, it
/// is repeated with more, so that cells are exact for any margin > 0.
///
/// The same for any number of threads. Throws std::invalid_argument if a cell reaches infinity (the
/// caller must bound them all) and for logWeights of another length than points.
template <int Dim>
std::vector<VoronoiCell<Dim>> voronoiCells(const Generators<Dim>& generators,
                                           const Box<Dim>& box = {}, double margin = 0);

}  // namespace plenum
