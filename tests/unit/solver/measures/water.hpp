// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes whose measures are known.
#pragma once

#include "solver/measures/observed.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace plenum::test {

/// The message of the InputError that `action` throws, or "no error".
template <class Action>
std::string refusalOf(Action&& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

/// Fluid of density 1000 on a cubic lattice that fills the box [0, extent], particles at cell
/// centres, V = spacing^Dim; walls `layers` deep under it and beside it, there `layers` higher than
/// the water.
template <int Dim>
Scene<Dim> stillWater(const Vec<Dim>& extent, double spacing, int layers = 0) {
  Scene<Dim> scene;
  scene.info.spacing = spacing;
  scene.info.materials = {{"water", 1000}};
  std::vector<Vec<Dim>> fluid, walls;
  std::array<int, 3> n{1, 1, 1};
  for (int a = 0; a < Dim; ++a)
    n[static_cast<std::size_t>(a)] = static_cast<int>(std::lround(extent[a] / spacing));
  const auto outside = [&](int a) { return Dim > a ? layers : 0; };
  for (int i = -outside(0); i < n[0] + outside(0); ++i)
    for (int j = -outside(1); j < n[1] + outside(1); ++j)
      for (int k = -outside(2); k < n[2] + outside(2); ++k) {
        const std::array<int, 3> cell{i, j, k};
        Vec<Dim> x;
        bool isFluid = true, isBeside = false;
        for (int a = 0; a < Dim; ++a) {
          const int c = cell[static_cast<std::size_t>(a)];
          x[a] = (c + 0.5) * spacing;
          const bool isOutside = c < 0 || c >= n[static_cast<std::size_t>(a)];
          if (isOutside) isFluid = false;
          if (isOutside && a < Dim - 1) isBeside = true;
        }
        const bool isAbove = x[Dim - 1] > extent[Dim - 1];
        if (isFluid || !isAbove || isBeside) (isFluid ? fluid : walls).push_back(x);
      }
  FieldSet fields{field::position, field::velocity, field::mass,
                  field::density,  field::pressure, field::id};
  scene.particles = ParticleSet<Dim>(fields, fluid.size(), walls.size());
  fluid.insert(fluid.end(), walls.begin(), walls.end());
  scene.info.domain = Box<Dim>::nothing();
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    scene.particles[field::position][i] = fluid[i];
    scene.particles[field::density][i] = 1000;
    scene.particles[field::mass][i] = 1000 * std::pow(spacing, Dim);
    scene.info.domain.extend(fluid[i]);
  }
  scene.info.domain = scene.info.domain.grown(spacing);
  return scene;
}

/// As a run with h = 1.5 d_ref and gravity against the last axis sees it.
template <int Dim>
Observed<Dim> observed(const Scene<Dim>& scene, const std::string& kernel = "wendland_c2") {
  static const SolverSettings settings;
  Observed<Dim> state{scene.particles,          scene.info, settings, KernelId::named(kernel),
                      1.5 * scene.info.spacing, {}};
  state.gravity[Dim - 1] = -9.81;
  return state;
}

}  // namespace plenum::test
