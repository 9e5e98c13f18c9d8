// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "ictools/ic_settings.hpp"

#include <memory>
#include <span>
#include <vector>

namespace plenum {

/// A place where particles stand closer, and how their spacing grows away from it; with its images
/// behind periodic faces.
template <int Dim>
class Refinement {
 public:
  /// `spacing` is d_ref [m].
  Refinement(RefineSettings settings, GeometryPtr<Dim> region, double spacing,
             const Box<Dim>& domain);

  const RefineSettings& settings() const { return settings_; }
  const Geometry<Dim>& region() const { return *region_; }

  /// How far from the place the spacing is below d_ref [m].
  double reach() const { return reach_; }

  /// Distances of points from the place [m], 0 inside of it; beyond `reach` something between that
  /// and the distance.
  void distances(std::span<const Vec<Dim>> points, std::span<double> result) const;

 private:
  RefineSettings settings_;
  GeometryPtr<Dim> region_;
  Box<Dim> bounds_;                ///< of the region
  std::vector<Vec<Dim>> periods_;  ///< to all images that may matter, itself included
  double reach_;
};

/// The spacing that is wanted at a place, over that of the scene:
/// s/d_ref = min(1, min over refinements of spacing + growth distance/d_ref).
template <int Dim>
class Resolution {
 public:
  /// `spacing` is d_ref [m].
  Resolution(std::vector<Refinement<Dim>> refinements, double spacing);

  const std::vector<Refinement<Dim>>& refinements() const { return refinements_; }

  /// result[k] = s/d_ref at points[k], in (0, 1]. May be asked from several threads.
  void at(std::span<const Vec<Dim>> points, std::span<double> result) const;

  /// result[k] = a distance from points[k] within which nothing is refined [m]; 0 where it is.
  void plainAround(std::span<const Vec<Dim>> points, std::span<double> result) const;

  double finest() const { return finest_; }    ///< s/d_ref in a refined place
  double steepest() const { return growth_; }  ///< largest |grad s|

 private:
  std::vector<Refinement<Dim>> refinements_;
  double spacing_, finest_ = 1, growth_ = 0;
};

template <int Dim>
using ResolutionPtr = std::shared_ptr<const Resolution<Dim>>;

/// s/d_ref at all points, from all threads.
template <int Dim>
std::vector<double> ratiosAt(const Resolution<Dim>& resolution, std::span<const Vec<Dim>> points);

}  // namespace plenum
