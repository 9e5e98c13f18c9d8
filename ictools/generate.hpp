// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/relaxation.hpp"
#include "ictools/scene_frame.hpp"
#include "particles/scene.hpp"

#include <filesystem>
#include <string>

namespace plenum {

/// What came of a case.
template <int Dim>
struct Generated {
  Scene<Dim> scene;
  std::vector<DensityProfilePtr<Dim>> profiles;  ///< of the materials; null where there is none
  std::optional<RelaxationResult> relaxation;    ///< if the case asks for one
};

/// What the case does not say.
template <int Dim>
struct GenerateOptions {
  RelaxationWatch watch = {};            ///< told of each iteration of a relaxation
  const Scene<Dim>* placesOf = nullptr;  ///< an earlier set of the case, whose places are taken
};

/// From a case to a set of particles: geometry, fluids, walls, container, numbers.
///
/// Fluid particles stand first, fluid by fluid, then walls; ids count walls first (1 ... Nw). Every
/// particle has position, velocity, mass, density, pressure, smoothing length and id; fluids also
/// their material, walls their wall, normal and depth behind the surface. `info.quality` holds the
/// figures that `describe` prints. Throws InputError with file, line, key and remedy.
template <int Dim>
Generated<Dim> generate(const CaseNode& root, const CaseSettings& settings,
                        const std::filesystem::path& casePath, const Warn& warn,
                        const GenerateOptions<Dim>& options = {});

/// Particles, masses, spacings and layers in some lines, for the terminal.
template <int Dim>
std::string describe(const Scene<Dim>& scene);

}  // namespace plenum
