// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/regions.hpp"
#include "ictools/scene_frame.hpp"

#include <string>
#include <vector>

namespace plenum {

/// The bounds of a region, for the eye that looks for a wrong unit.
struct PartSize {
  std::string name;
  std::string description;
  std::vector<double> extent;  ///< [m]
  std::vector<double> extentInSpacings;
};

/// Sizes of all finite regions. Warns of those that
/// - are larger than a billion spacings in volume: in millimetres?
/// - are smaller than 3 spacings along every axis;
/// - lie so far from the origin that floats have steps above 1e-3 d_ref there, and ten times their
///   size.
template <int Dim>
std::vector<PartSize> checkParts(const CaseSettings& settings, const Regions<Dim>& regions,
                                 const SceneFrame<Dim>& frame, Findings& findings);

}  // namespace plenum
