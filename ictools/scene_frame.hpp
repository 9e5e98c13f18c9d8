// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/box.hpp"
#include "particles/case_settings.hpp"

#include <cmath>
#include <functional>
#include <string>

namespace plenum {

/// Somewhere to say what is not wrong but worth knowing.
using Warn = std::function<void(const std::string&)>;

/// What all parts of a scene share.
template <int Dim>
struct SceneFrame {
  double spacing = 0;  ///< d_ref [m]
  Box<Dim> domain;     ///< periodic axes as in the case; open axes infinite
  SolverSettings solver;
  /// (m/rho)^(1/d) on the first fluid's lattice, with solver.adaptive [m]; 0: d_ref counts.
  double cellSize = 0;

  /// Of a particle of the first fluid [m].
  double smoothingLength() const {
    return solver.smoothingLength * (cellSize > 0 ? cellSize : spacing);
  }
  double support() const { return 2 * smoothingLength(); }

  /// Of a particle of volume m/rho [m^d], with solver.adaptive [m].
  double lengthOfVolume(double volume) const {
    return solver.smoothingLength * std::pow(volume, 1.0 / Dim);
  }

  /// `box` with the domain's faces on periodic axes.
  Box<Dim> clipped(Box<Dim> box) const {
    for (int a = 0; a < Dim; ++a) {
      if (!domain.isPeriodic(a)) continue;
      box.lower[a] = domain.lower[a];
      box.upper[a] = domain.upper[a];
      box.periodic[static_cast<std::size_t>(a)] = true;
    }
    return box;
  }
};

/// Throws InputError if a periodic axis is shorter than twice the kernel's support, so that a
/// particle would meet two images of the same neighbour.
template <int Dim>
SceneFrame<Dim> sceneFrame(const CaseNode& root, const CaseSettings& settings);

}  // namespace plenum
