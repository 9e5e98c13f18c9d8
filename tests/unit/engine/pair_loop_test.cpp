// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/pair_loop.hpp"

#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plenum {
namespace {

/// Counts neighbours in the support, weights them and remembers who they were.
struct Probe {
  static constexpr FieldSet reads{field::mass, field::velocity};
  static constexpr FieldSet writes{field::densityRate, field::velocityChange};

  template <class Real, int Dim>
  void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.densityRate += ij.j.mass * ij.W;
    i.velocityChange += ij.j.mass * ij.gradW() * ij.velocityDotR();
  }
  template <class Real, int Dim>
  void self(const ParticleView<Real, Dim>& i, Real W0, Sums<Real, Dim>& sums) const {
    sums.densityRate += i.mass * W0;
  }
};

/// The scalar half of Probe: what walls can receive.
struct ScalarProbe {
  static constexpr FieldSet reads{field::mass};
  static constexpr FieldSet writes{field::densityRate};

  template <class Real, int Dim>
  void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.densityRate += ij.j.mass * ij.W;
  }
  template <class Real, int Dim>
  void self(const ParticleView<Real, Dim>& i, Real W0, Sums<Real, Dim>& sums) const {
    sums.densityRate += i.mass * W0;
  }
};

template <class T>
class PairLoopTest : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(PairLoopTest, Dimensions);

bool isSource(Group group, std::size_t j, std::size_t nFluid) {
  return group == Group::all || (group == Group::fluids) == (j < nFluid);
}

bool receives(Group group, std::size_t i, std::size_t nFluid) { return isSource(group, i, nFluid); }

template <int Dim>
void expectEqualToDoubleLoop(bool periodic, Group receivers, Group sources) {
  using K = Kernel<Dim, kernel::WendlandC4>;
  const Box<Dim> box = test::unitBox<Dim>(periodic);
  auto particles = test::randomParticles<Dim>(box, 200, 80);
  const double h = 0.15;
  Engine<Dim> engine(box, {2 * h, 0.2, true});
  engine.update(particles);
  std::ranges::fill(particles[field::densityRate], -1.0);
  const bool fluidsOnly = receivers == Group::fluids;
  if (fluidsOnly)
    runPass(Pass<kernel::WendlandC4, Probe>{{}, h, {}, receivers, sources}, engine, particles);
  else
    runPass(Pass<kernel::WendlandC4, ScalarProbe>{{}, h, {}, receivers, sources}, engine,
            particles);

  const auto x = particles[field::position];
  const auto v = particles[field::velocity];
  const auto m = particles[field::mass];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!receives(receivers, i, particles.nFluid())) {
      EXPECT_EQ(particles[field::densityRate][i], -1);  // untouched
      continue;
    }
    long double sum = static_cast<long double>(m[i]) * K::W(0, h);
    Vec<Dim> change;
    for (std::size_t j = 0; j < particles.size(); ++j) {
      const Vec<Dim> r = box.nearestImage(x[i] - x[j]);
      if (j == i || norm(r) >= 2 * h || !isSource(sources, j, particles.nFluid())) continue;
      sum += static_cast<long double>(m[j]) * K::W(norm(r), h);
      change += m[j] * K::F(norm(r), h) * dot(v[i] - v[j], r) * r;
    }
    // A sum of some 100 terms of one sign: round-off of a few ulp.
    EXPECT_NEAR(particles[field::densityRate][i], static_cast<double>(sum),
                1e-14 * static_cast<double>(sum));
    if (!fluidsOnly) continue;
    // Terms of both signs of up to about 100 each: round-off of the largest.
    EXPECT_LE(norm(particles[field::velocityChange][i] - change), 1e-12 * (1 + norm(change)));
  }
}

TYPED_TEST(PairLoopTest, EqualsADoubleLoopOverAllPairs) {
  for (const bool periodic : {false, true})
    for (const Group receivers : {Group::all, Group::fluids, Group::walls})
      for (const Group sources : {Group::all, Group::fluids, Group::walls})
        expectEqualToDoubleLoop<TypeParam::value>(periodic, receivers, sources);
}

TYPED_TEST(PairLoopTest, KernelChosenAtRunTimeGivesTheSameSums) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(true);
  auto particles = test::randomParticles<Dim>(box, 300, 0);
  Engine<Dim> engine(box, {0.3, 0.2, false});
  engine.update(particles);
  runPass(Pass<kernel::Convex, Probe>{{}, 0.15, {}}, engine, particles);
  const auto span = particles[field::densityRate];
  const std::vector<double> fixed(span.begin(), span.end());
  const kernel::Any any{KernelId::named("convex")};
  runPass(Pass<kernel::Any, Probe>{any, 0.15, {}}, engine, particles);
  for (std::size_t i = 0; i < fixed.size(); ++i)  // the compiler may order operations differently
    EXPECT_NEAR(span[i], fixed[i], 1e-14 * fixed[i]);
}

TYPED_TEST(PairLoopTest, CoincidentParticlesGiveFiniteSums) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(false);
  kernel::forEachProfile([&](auto profile) {
    auto particles = test::randomParticles<Dim>(box, 2, 0);
    particles[field::position][1] = particles[field::position][0];
    Engine<Dim> engine(box, {0.3, 0.2, false});
    engine.update(particles);
    runPass(Pass<decltype(profile), Probe>{profile, 0.15, {}}, engine, particles);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_TRUE(std::isfinite(particles[field::densityRate][i])) << profile.name;
      EXPECT_EQ(norm(particles[field::velocityChange][i]), 0) << profile.name;
    }
  });
}

}  // namespace
}  // namespace plenum
