// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ictools/relaxation.hpp"
#include "ictools/scene_frame.hpp"
#include "particles/scene.hpp"

#include <filesystem>
#include <string>

namespace plenum {

/// From a case to a set of particles: geometry, fluids, walls, container, numbers.
///
/// Fluid particles stand first, fluid by fluid, then walls; ids count walls first (1 ... Nw). Every
/// particle has position, velocity, mass, density, pressure, smoothing length and id; fluids also
/// their material, walls their wall, normal and depth behind the surface. `info.quality` holds the
/// figures that `describe` prints. Throws InputError with file, line, key and remedy.
template <int Dim>
Scene<Dim> generate(const CaseNode& root, const CaseSettings& settings,
                    const std::filesystem::path& casePath, const Warn& warn,
                    const RelaxationWatch& watch = {});

/// Particles, masses, spacings and layers in some lines, for the terminal.
template <int Dim>
std::string describe(const Scene<Dim>& scene);

}  // namespace plenum
