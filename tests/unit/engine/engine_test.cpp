// SPDX-License-Identifier: GPL-3.0-or-later
//
// When the engine searches anew, and that its sums are right whether it did or not.
#include "engine/engine.hpp"

#include "engine/pass_of.hpp"
#include "particles/errors.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/support/pair_sums.hpp"
#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>

#include <iostream>

namespace plenum {
namespace {

template <class T>
class EngineTest : public testing::Test {};
TYPED_TEST_SUITE(EngineTest, test::Dimensions);

TYPED_TEST(EngineTest, SearchesOnlyWhenSomebodyMayHaveMovedHalfTheSkin) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(false);
  auto particles = test::randomParticles<Dim>(box, 100, 20);
  Engine<Dim> engine(box, {0.2, 0.2});
  EXPECT_TRUE(engine.update(particles));
  EXPECT_FALSE(engine.update(particles));
  engine.moved(0.0199);  // half the skin: .02 m
  EXPECT_FALSE(engine.update(particles));
  engine.moved(0.0002);
  EXPECT_TRUE(engine.update(particles));
  EXPECT_FALSE(engine.update(particles)) << "the way starts at the search";
  engine.forget();
  EXPECT_TRUE(engine.update(particles));
  EXPECT_EQ(engine.nRebuilds(), 3u);
}

TYPED_TEST(EngineTest, SumsAreRightWhileParticlesMove) {
  constexpr int Dim = TypeParam::value;
  for (const Precision precision : test::bothPrecisions)
    for (const bool periodic : {false, true}) {
      const Box<Dim> box = test::unitBox<Dim>(periodic);
      auto particles = test::randomParticles<Dim>(box, 300, 50);
      Engine<Dim> engine(box, {0.2, 0.2, false, precision});
      std::mt19937_64 generator(7);
      std::uniform_real_distribution<double> uniform(-1, 1);
      const double distance = 0.0041;  // five steps are just more than half the skin
      std::size_t nSearches = 0;
      for (int step = 0; step < 21; ++step) {
        nSearches += engine.update(particles);
        EXPECT_LE(test::deviationOf(engine, particles, box), test::toleranceOf(precision))
            << test::nameOf(precision) << ", step " << step;
        for (auto& x : particles[field::position]) {
          Vec<Dim> way;
          for (int a = 0; a < Dim; ++a) way[a] = uniform(generator);
          // All of them the whole way that is announced.
          x = box.wrap(x + distance / norm(way) * way);
        }
        engine.moved(distance);
      }
      // In two dimensions and more no cluster spans the box, so that the list lives its five steps.
      if (Dim > 1 || !periodic) {
        EXPECT_LE(nSearches, 6u);
      }
      EXPECT_GE(nSearches, 5u);
    }
}

/// Few particles in a small periodic box: clusters as large as the box, whose particles have no
/// image that is surely the nearest.
TYPED_TEST(EngineTest, SumsAreRightWhereClustersSpanAPeriod) {
  constexpr int Dim = TypeParam::value;
  for (const Precision precision : test::bothPrecisions)
    for (const std::size_t n : {2, 5, 8, 12, 20}) {
      const Box<Dim> box = test::unitBox<Dim>(true);
      auto particles = test::randomParticles<Dim>(box, n, 0);
      Engine<Dim> engine(box, {0.49, 0.2, false, precision});
      std::mt19937_64 generator(7);
      std::uniform_real_distribution<double> uniform(-1, 1);
      for (int step = 0; step < 20; ++step) {
        engine.update(particles);
        // Of so few pairs all may be at the rim of the support, where W is small and as wrong as
        // elsewhere.
        EXPECT_LE(test::deviationOf(engine, particles, box), 10 * test::toleranceOf(precision))
            << test::nameOf(precision) << ", " << n << " particles, step " << step;
        for (auto& x : particles[field::position])
          for (int a = 0; a < Dim; ++a) x[a] += 0.02 / std::sqrt(Dim) * uniform(generator);
        for (auto& x : particles[field::position]) x = box.wrap(x);
        engine.moved(0.02);
      }
    }
}

TYPED_TEST(EngineTest, NoticesThatThereAreOtherParticles) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(false);
  Engine<Dim> engine(box, {0.3, 0.2, false, Precision::doubled});
  for (const std::size_t n : {100, 300, 0, 7}) {
    auto particles = test::randomParticles<Dim>(box, n, n / 3);
    EXPECT_TRUE(engine.update(particles));
    EXPECT_LE(test::deviationOf(engine, particles, box), test::toleranceOf(Precision::doubled))
        << n;
  }
}

/// Particles that escaped must not spoil the numbers of those that stayed: a cluster that held some
/// of both would have positions in float relative to a centre far away.
template <int Dim>
void expectRightWithStrays(double distance) {
  const Box<Dim> box = test::unitBox<Dim>(false);
  for (const Precision precision : test::bothPrecisions)
    for (const std::size_t nStrays : {1, 3, 10}) {
      auto particles = test::randomParticles<Dim>(box, 200, 0);
      const auto x = particles[field::position];
      for (std::size_t i = 0; i < nStrays; ++i)
        x[i] += Vec<Dim>::filled(i % 2 == 0 ? distance : -distance);
      Engine<Dim> engine(box, {0.3, 0.2, false, precision});
      engine.update(particles);
      const double deviation = test::deviationOf(engine, particles, box);
      // Not more than what positions of that size are rounded to, and twice that, in h.
      const double rounding = precision == Precision::mixed ? 0 : 4e-16 * distance / 0.15;
      EXPECT_LE(deviation, test::toleranceOf(precision) + rounding)
          << test::nameOf(precision) << ", " << nStrays << " strays, " << distance << " m away";
      std::cout << "  " << nStrays << " strays at " << distance << " m, " << test::nameOf(precision)
                << ": " << deviation << "\n";
    }
}

TYPED_TEST(EngineTest, SumsAreRightWhenAFewParticlesAreTenBoxesAway) {
  expectRightWithStrays<TypeParam::value>(10);
}

TYPED_TEST(EngineTest, SumsAreRightWhenAFewParticlesAreAThousandBoxesAway) {
  expectRightWithStrays<TypeParam::value>(1000);
}

TYPED_TEST(EngineTest, SumsAreRightWhenAFewParticlesAreAMillionBoxesAway) {
  expectRightWithStrays<TypeParam::value>(1e6);
}

TEST(Engine, RefusesAPeriodicBoxThatIsTooSmall) {
  try {
    Engine<2>(test::unitBox<2>(true), {0.51, 0.2, false});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("periodic axis x"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("smoothing_length"), std::string::npos);
  }
}

}  // namespace
}  // namespace plenum
