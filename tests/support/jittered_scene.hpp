// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/scene.hpp"
#include "tests/support/random_particles.hpp"

#include <cmath>

namespace plenum::test {

/// A gas of `perAxis`^Dim particles of density 1 on a cubic lattice in the unit box, moved by up to
/// `jitter` spacings, with random velocities up to `speed` [m/s].
template <int Dim>
Scene<Dim> jitteredScene(int perAxis, bool periodic, double jitter = 0.2, double speed = 0.1,
                         unsigned seed = 1) {
  Scene<Dim> scene;
  scene.info.title = "jittered lattice";
  scene.info.spacing = 1.0 / perAxis;
  scene.info.domain = unitBox<Dim>(periodic);
  scene.info.materials = {{"gas", 1.0}};
  std::size_t n = 1;
  for (int a = 0; a < Dim; ++a) n *= static_cast<std::size_t>(perAxis);
  scene.particles = randomParticles<Dim>(scene.info.domain, n, 0, seed);
  std::mt19937_64 generator(seed + 100);
  std::uniform_real_distribution<double> uniform(-1, 1);
  ParticleSet<Dim>& p = scene.particles;
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t rest = i;
    for (int a = 0; a < Dim; ++a) {
      const auto k = static_cast<double>(rest % static_cast<std::size_t>(perAxis));
      rest /= static_cast<std::size_t>(perAxis);
      p[field::position][i][a] = (k + 0.5 + jitter * uniform(generator)) / perAxis;
      p[field::velocity][i][a] = speed * uniform(generator);
    }
    p[field::mass][i] = 1.0 / static_cast<double>(n);
    p[field::density][i] = 1;
  }
  return scene;
}

}  // namespace plenum::test
