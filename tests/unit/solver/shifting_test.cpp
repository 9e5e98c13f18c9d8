// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lind et al. 2012, doi 10.1016/j.jcp.2011.10.027: away from where particles are dense.
#include "solver/shifting.hpp"

#include "particles/kernels.hpp"
#include "solver/pair_pass.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/support/jittered_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace plenum {
namespace {

constexpr double coefficient = 1.7;

template <class T>
class ShiftingTest : public testing::Test {};
TYPED_TEST_SUITE(ShiftingTest, test::Dimensions);

/// What one call of shift() does to the particles of a scene, with the pass that a case gets.
template <int Dim>
struct Shifted {
  std::vector<Vec<Dim>> way;
  double longest = 0;  ///< as shift() returns it

  Shifted(Scene<Dim> scene, double dt, bool freeSurface) {
    SolverSettings settings;
    settings.shifting = ShiftingSettings{coefficient, freeSurface};
    const double h = settings.smoothingLength * scene.info.spacing;
    typename Engine<Dim>::Options options;
    options.support = 2 * h;
    options.precision = Precision::doubled;
    options.units = Units::near(h, scene.particles[field::mass][0], settings.soundSpeed);
    Engine<Dim> engine(scene.info.domain, options);
    // The engine sorts: ways are told by id, as `scene` had them.
    ParticleSet<Dim>& p = scene.particles;
    std::vector<Vec<Dim>> before(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      p[field::id][i] = i + 1;
      before[i] = p[field::position][i];
    }
    engine.update(p);
    const Phases phases(scene.info.materials, settings);
    const auto passes =
        selectPasses<Dim>(settings, phases, {scene.info.spacing, false, false}, engine.units());
    engine.run(passes.concentration, p);
    longest = shift(*settings.shifting, h, dt, engine, p);
    way.resize(p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
      way[p[field::id][i] - 1] = p[field::position][i] - before[p[field::id][i] - 1];
  }

  double longestWay() const {
    double most = 0;
    for (const Vec<Dim>& w : way) most = std::max(most, norm(w));
    return most;
  }
};

/// Lind's gradient of the concentration at each particle and what tells a free surface,
/// -sum V r.grad W, summed over all pairs.
template <int Dim>
struct Around {
  Vec<Dim> gradient{};
  double divergence = 0;
};

template <int Dim>
std::vector<Around<Dim>> aroundAll(const Scene<Dim>& scene) {
  using W = Kernel<Dim, kernel::WendlandC2>;
  const ParticleSet<Dim>& p = scene.particles;
  const double spacing = scene.info.spacing, h = 1.5 * spacing;
  std::vector<Around<Dim>> all(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < p.size(); ++j) {
      const Vec<Dim> r = p[field::position][i] - p[field::position][j];
      const double distance = norm(r);
      if (j == i || distance >= 2 * h) continue;
      const double volume = p[field::mass][j] / p[field::density][j];
      const Vec<Dim> gradW = W::F(distance, h) * r;
      const double crowd = 1 + 0.2 * std::pow(W::W(distance, h) / W::W(spacing, h), 4);
      all[i].gradient += volume * crowd * gradW;
      all[i].divergence -= volume * dot(r, gradW);
    }
  return all;
}

/// Two particles in a large box, one spacing apart along x.
template <int Dim>
Scene<Dim> twoParticles() {
  Scene<Dim> scene = test::jitteredScene<Dim>(10, false);
  ParticleSet<Dim> two(scene.particles.fields(), 2, 0);
  for (std::size_t i = 0; i < 2; ++i) {
    two[field::position][i] = Vec<Dim>::filled(0.5);
    two[field::position][i][0] = 0.5 + 0.1 * static_cast<double>(i);
    two[field::velocity][i][Dim - 1] = i == 0 ? 3 : -0.5;
    two[field::mass][i] = 0.02 * power<Dim>(0.1);
    two[field::density][i] = 1;
  }
  scene.particles = std::move(two);
  return scene;
}

TYPED_TEST(ShiftingTest, TwoParticlesPartByTheirSpeeds) {
  constexpr int dim = TypeParam::value;
  const double h = 0.15, dt = 1e-3;
  const Shifted<dim> shifted(twoParticles<dim>(), dt, false);
  // A h |v| dt V (1 + .2) |dW/dr|: W(r) = W(d_ref) here.
  const double slope = -0.1 * Kernel<dim, kernel::WendlandC2>::F(0.1, h);
  const double perSpeed = coefficient * h * dt * 0.02 * power<dim>(0.1) * 1.2 * slope;
  ASSERT_LT(3 * perSpeed, 0.1 * h);
  // Places are round to 1e-16.
  EXPECT_NEAR(shifted.way[0][0], -3 * perSpeed, 2e-16);
  EXPECT_NEAR(shifted.way[1][0], 0.5 * perSpeed, 2e-16);
  EXPECT_GT(perSpeed, 1e-7) << "nothing to compare";
  for (int a = 1; a < dim; ++a)
    for (const Vec<dim>& way : shifted.way) EXPECT_EQ(way[a], 0);
  EXPECT_NEAR(shifted.longest, 3 * perSpeed, 1e-14 * perSpeed);  // some roundings
}

TYPED_TEST(ShiftingTest, EveryoneGoesAgainstTheGradientAndNobodyFurtherThanATenthOfH) {
  constexpr int dim = TypeParam::value;
  const Scene<dim> scene = test::jitteredScene<dim>(dim == 3 ? 8 : 16, false, 0.3, 1.0);
  const double h = 1.5 * scene.info.spacing, dt = 0.03;
  const auto around = aroundAll(scene);
  const Shifted<dim> shifted(scene, dt, false);
  std::size_t nFree = 0, nCapped = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const double speed = norm(scene.particles[field::velocity][i]);
    Vec<dim> expected = -(coefficient * h * speed * dt) * around[i].gradient;
    const bool isCapped = norm(expected) > 0.1 * h;
    if (isCapped) expected = (0.1 * h / norm(expected)) * expected;
    ++(isCapped ? nCapped : nFree);
    // Places are round to 1e-16, gradients to 1e-15 of summands of about 1/h.
    EXPECT_LE(norm(shifted.way[i] - expected), 1e-14);
  }
  EXPECT_GT(nFree, around.size() / 8);
  EXPECT_GT(nCapped, around.size() / 8);
  EXPECT_NEAR(shifted.longest, 0.1 * h, 1e-16);
  EXPECT_NEAR(shifted.longestWay(), shifted.longest, 1e-15);  // places are round to 1e-16
}

/// Uncapped ways, too, are told by their longest: engines search anew by it.
TYPED_TEST(ShiftingTest, ReturnsTheLongestWay) {
  constexpr int dim = TypeParam::value;
  const Scene<dim> scene = test::jitteredScene<dim>(dim == 3 ? 8 : 16, false, 0.3, 1.0);
  const Shifted<dim> shifted(scene, 1e-4, false);
  EXPECT_LT(shifted.longest, 0.1 * 1.5 * scene.info.spacing);
  EXPECT_GT(shifted.longest, 1e-6);
  EXPECT_NEAR(shifted.longest, shifted.longestWay(), 1e-15);  // places are round to 1e-16
}

TYPED_TEST(ShiftingTest, NobodyMovesAtAFreeSurface) {
  constexpr int dim = TypeParam::value;
  const Scene<dim> scene = test::jitteredScene<dim>(dim == 3 ? 10 : 16, false, 0.1, 1.0);
  const auto around = aroundAll(scene);
  const Shifted<dim> everyone(scene, 1e-3, false), inside(scene, 1e-3, true);
  std::size_t nAtSurface = 0, nInside = 0;
  double longestInside = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    EXPECT_GT(norm(everyone.way[i]), 0);
    // Lee et al. 2008: less than 1.5 in 2-D is the surface; a lattice's divergence is never as
    // near to that as rounding.
    const bool atSurface = around[i].divergence < 0.75 * dim;
    ++(atSurface ? nAtSurface : nInside);
    EXPECT_EQ(inside.way[i], atSurface ? Vec<dim>{} : everyone.way[i]);
    if (!atSurface) longestInside = std::max(longestInside, norm(inside.way[i]));
    // All in the outermost layer, and nobody three layers below it.
    double depth = 1;
    for (int a = 0; a < dim; ++a) {
      const double x = scene.particles[field::position][i][a];
      depth = std::min({depth, x, 1 - x});
    }
    if (depth < 0.7 * scene.info.spacing) {
      EXPECT_TRUE(atSurface);
    }
    if (depth > 3 * scene.info.spacing) {
      EXPECT_FALSE(atSurface);
    }
  }
  EXPECT_GT(nAtSurface, 0u);
  EXPECT_GT(nInside, 0u);
  EXPECT_NEAR(inside.longest, longestInside, 1e-15);  // who stays is not counted
}

/// Layers that are further apart the larger x is: towards the sparse side.
TEST(Shifting, GoesToTheSparseSide) {
  Scene<2> scene = test::jitteredScene<2>(16, true, 0, 0);
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    double& x = scene.particles[field::position][i][0];
    x = 0.1 + 0.6 * x + 0.2 * x * x;
    scene.particles[field::velocity][i] = {{1, 1}};
  }
  const Shifted<2> shifted(scene, 1e-3, false);
  std::size_t nSeen = 0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double x = scene.particles[field::position][i][0];
    if (x < 0.3 || x > 0.7) continue;  // within reach of the edges
    ++nSeen;
    EXPECT_GT(shifted.way[i][0], 0);
    EXPECT_NEAR(shifted.way[i][1], 0, 1e-15);  // rows are alike: places are round to 1e-16
  }
  EXPECT_GT(nSeen, 16u);
}

}  // namespace
}  // namespace plenum
