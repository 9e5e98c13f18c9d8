// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/voids.hpp"

#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum {
namespace {

/// The definition, point by point.
template <int Dim>
double byDefinition(const ParticleSet<Dim>& particles, const SceneInfo<Dim>& info,
                    bool freeSurface) {
  const Box<Dim>& box = info.domain;
  const double spacing = info.spacing;
  std::array<std::size_t, Dim> shape;
  std::size_t size = 1;
  for (int a = 0; a < Dim; ++a)
    size *= shape[static_cast<std::size_t>(a)] =
        static_cast<std::size_t>(std::ceil(3 * box.extent()[a] / spacing));
  double points = 0, holes = 0;
  for (std::size_t k = 0; k < size; ++k) {
    Vec<Dim> x;
    std::size_t rest = k;
    for (int a = 0; a < Dim; ++a) {
      const std::size_t n = shape[static_cast<std::size_t>(a)];
      x[a] = box.lower[a] +
             box.extent()[a] * (static_cast<double>(rest % n) + 0.5) / static_cast<double>(n);
      rest /= n;
    }
    std::array<bool, 8> seen{};
    bool near = false;
    for (const Vec<Dim>& place : particles[field::position]) {
      const Vec<Dim> d = box.nearestImage(place - x);
      near = near || norm(d) <= spacing;
      if (norm(d) >= 2 * spacing) continue;
      std::size_t orthant = 0;
      for (int a = 0; a < Dim; ++a) orthant = 2 * orthant + (d[a] > 0 ? 1 : 0);
      seen[orthant] = true;
    }
    if (freeSurface &&
        !std::all_of(seen.begin(), seen.begin() + (1 << Dim), [](bool s) { return s; }))
      continue;
    points += 1;
    holes += !near;
  }
  return points > 0 ? holes / points : 0;
}

template <int Dim>
void expectTheDefinition(std::size_t n, double spacing) {
  for (const bool periodic : {false, true}) {
    Scene<Dim> scene;
    scene.info.spacing = spacing;
    scene.info.domain = test::unitBox<Dim>(periodic);
    scene.particles = test::randomParticles<Dim>(scene.info.domain, n, 0);
    for (const bool freeSurface : {false, true}) {
      const double expected = byDefinition(scene.particles, scene.info, freeSurface);
      EXPECT_GT(expected, 0.01) << "the scene has holes";
      EXPECT_EQ(measureVoids(scene.particles, scene.info, freeSurface), expected)
          << Dim << "-D, periodic " << periodic << ", free surface " << freeSurface;
    }
  }
}

// Random places leave holes of more than a spacing: as many particles as would fit on a lattice.
TEST(Voids, AreAsDefinedIn1D) { expectTheDefinition<1>(300, 1.0 / 300); }
TEST(Voids, AreAsDefinedIn2D) { expectTheDefinition<2>(400, 1.0 / 20); }
TEST(Voids, AreAsDefinedIn3D) { expectTheDefinition<3>(700, 1.0 / 9); }

TEST(Voids, OfAVesselThatMovesGoAlong) {
  Scene<2> scene;
  scene.info.spacing = 0.05;
  scene.info.domain = test::unitBox<2>(false);
  scene.particles = test::randomParticles<2>(scene.info.domain, 400, 0);
  scene.info.walls = {{"vessel", "lattice", 4, 0.2, 1.0, {}}};
  const double before = measureVoids(scene.particles, scene.info, true);
  for (Vec<2>& x : scene.particles[field::position]) x += Vec<2>{{3, -1}};
  EXPECT_EQ(measureVoids(scene.particles, scene.info, true), 0) << "nobody is left there";
  scene.info.walls[0].motion.velocity = {1.5, -0.5, 0};
  scene.info.time = 2;
  EXPECT_NEAR(measureVoids(scene.particles, scene.info, true), before,
              1e-3);  // a point on the edge of a hole may round either way
}

}  // namespace
}  // namespace plenum
