// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/jittered_scene.hpp"

namespace plenum::test {

/// The gas of `jitteredScene` in a box of walls, four layers on all sides, closed and not periodic.
/// Wall 0 is where x < 1/2, wall 1 the rest.
template <int Dim>
Scene<Dim> walledScene(int perAxis, double jitter = 0.2, double speed = 0.1) {
  constexpr int layers = 4;
  const Scene<Dim> gas = jitteredScene<Dim>(perAxis, false, jitter, speed);
  std::vector<Vec<Dim>> places;
  const int side = perAxis + 2 * layers;
  int nPlaces = 1;
  for (int a = 0; a < Dim; ++a) nPlaces *= side;
  for (int k = 0; k < nPlaces; ++k) {
    Vec<Dim> x;
    bool isInside = true;
    for (int a = 0, rest = k; a < Dim; ++a, rest /= side) {
      x[a] = (rest % side - layers + 0.5) / perAxis;
      isInside = isInside && x[a] > 0 && x[a] < 1;
    }
    if (!isInside) places.push_back(x);
  }
  Scene<Dim> scene{gas.info, {}};
  const std::size_t nFluid = gas.particles.size();
  const FieldSet fields =
      gas.particles.fields() | FieldSet{field::wall, field::normal, field::wallDistance};
  scene.particles = ParticleSet<Dim>(fields, nFluid, places.size());
  ParticleSet<Dim>& p = scene.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool isWall = i >= nFluid;
    p[field::position][i] = isWall ? places[i - nFluid] : gas.particles[field::position][i];
    p[field::velocity][i] = isWall ? Vec<Dim>{} : gas.particles[field::velocity][i];
    p[field::mass][i] = gas.particles[field::mass][0];
    p[field::density][i] = 1;
    p[field::id][i] = isWall ? i - nFluid + 1 : places.size() + i + 1;
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    p[field::wall][k] = places[k][0] < 0.5 ? 0 : 1;
    p[field::normal][k][0] = places[k][0] < 0.5 ? 1 : -1;
  }
  for (int a = 0; a < Dim; ++a) {
    scene.info.domain.lower[a] = -static_cast<double>(layers) / perAxis;
    scene.info.domain.upper[a] = 1 + static_cast<double>(layers) / perAxis;
  }
  const double thickness = static_cast<double>(layers) / perAxis;
  scene.info.walls = {{"left", "lattice", layers, thickness, 1.0, {}},
                      {"right", "lattice", layers, thickness, 1.0, {}}};
  return scene;
}

}  // namespace plenum::test
