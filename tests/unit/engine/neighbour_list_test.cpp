// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/engine.hpp"

#include "particles/errors.hpp"
#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <map>
#include <set>

namespace plenum {
namespace {

template <class T>
class NeighbourListTest : public testing::Test {};

using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(NeighbourListTest, Dimensions);

using Neighbours = std::map<std::uint64_t, std::multiset<std::uint64_t>>;  // by id

/// Pairs of the list closer than `radius`. The list must hold them all; what it holds beyond is
/// its skin.
template <int Dim>
Neighbours fromList(const Engine<Dim>& engine, const ParticleSet<Dim>& particles,
                    const Box<Dim>& box, double radius) {
  Neighbours result;
  const auto x = particles[field::position];
  const auto ids = particles[field::id];
  for (const auto& block : engine.neighbours().blocks())
    for (std::size_t i = block.first; i < block.last; ++i) {
      for (const auto j : engine.neighbours().fluidsOf(block, i)) EXPECT_LT(j, particles.nFluid());
      for (const auto j : engine.neighbours().wallsOf(block, i)) EXPECT_GE(j, particles.nFluid());
      result[ids[i]];
      for (const auto j : engine.neighbours().allOf(block, i))
        if (normSquared(box.nearestImage(x[i] - x[j])) < radius * radius)
          result[ids[i]].insert(ids[j]);
    }
  return result;
}

template <int Dim>
Neighbours bySearchOfAll(const ParticleSet<Dim>& particles, std::size_t nReceivers,
                         const Box<Dim>& box, double radius) {
  Neighbours result;
  const auto x = particles[field::position];
  const auto ids = particles[field::id];
  for (std::size_t i = 0; i < nReceivers; ++i) {
    result[ids[i]];
    for (std::size_t j = 0; j < particles.size(); ++j)
      if (j != i && normSquared(box.nearestImage(x[i] - x[j])) < radius * radius)
        result[ids[i]].insert(ids[j]);
  }
  return result;
}

TYPED_TEST(NeighbourListTest, EqualsSearchOfAllPairs) {
  constexpr int Dim = TypeParam::value;
  for (const bool periodic : {false, true})
    for (const bool wallsReceive : {false, true})
      for (const double support : {0.5, 0.3, 0.12}) {
        const Box<Dim> box = test::unitBox<Dim>(periodic);
        auto particles = test::randomParticles<Dim>(box, 300, 100);
        Engine<Dim> engine(box, {support, 0.2, wallsReceive});
        engine.update(particles);
        const std::size_t nReceivers = wallsReceive ? particles.size() : particles.nFluid();
        EXPECT_EQ(fromList(engine, particles, box, support),
                  bySearchOfAll(particles, nReceivers, box, support));
      }
}

TYPED_TEST(NeighbourListTest, HoldsUntilSomebodyMovedHalfTheSkin) {
  constexpr int Dim = TypeParam::value;
  for (const bool periodic : {false, true}) {
    const Box<Dim> box = test::unitBox<Dim>(periodic);
    const double support = 0.2;
    auto particles = test::randomParticles<Dim>(box, 300, 50);
    Engine<Dim> engine(box, {support, 0.2, false});
    EXPECT_TRUE(engine.update(particles));
    EXPECT_FALSE(engine.update(particles));
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    bool rebuilt = false;
    for (int step = 0; step < 20; ++step) {
      for (auto& x : particles[field::position])
        for (int a = 0; a < Dim; ++a) x[a] += 0.004 * uniform(generator);
      rebuilt |= engine.update(particles);
      EXPECT_EQ(fromList(engine, particles, box, support),
                bySearchOfAll(particles, particles.nFluid(), box, support));
    }
    EXPECT_TRUE(rebuilt);
  }
}

TYPED_TEST(NeighbourListTest, FindsParticlesThatFlewFarAway) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(false);
  auto particles = test::randomParticles<Dim>(box, 200, 0);
  for (std::size_t i = 0; i < 10; ++i)  // two clouds, far out on either side
    particles[field::position][i] *= i < 5 ? 1.0 : -1.0;
  for (std::size_t i = 0; i < 10; ++i)
    particles[field::position][i] += Vec<Dim>::filled(i < 5 ? 1e7 : -1e7);
  Engine<Dim> engine(box, {0.3, 0.2, false});
  engine.update(particles);
  EXPECT_EQ(fromList(engine, particles, box, 0.3),
            bySearchOfAll(particles, particles.nFluid(), box, 0.3));
}

TYPED_TEST(NeighbourListTest, IsTheSameForAnyNumberOfThreads) {
  constexpr int Dim = TypeParam::value;
  const Box<Dim> box = test::unitBox<Dim>(true);
  std::vector<std::vector<std::uint64_t>> lists;
  for (const int nThreads : {1, 2, 3}) {
    omp_set_num_threads(nThreads);
    auto particles = test::randomParticles<Dim>(box, 3000, 0);
    Engine<Dim> engine(box, {0.08, 0.2, false});
    engine.update(particles);
    std::vector<std::uint64_t> all;
    for (const auto& block : engine.neighbours().blocks())
      for (std::size_t i = block.first; i < block.last; ++i)
        for (const auto j : engine.neighbours().allOf(block, i))
          all.push_back(particles[field::id][j]);
    lists.push_back(all);
  }
  omp_set_num_threads(omp_get_num_procs());
  EXPECT_EQ(lists[0], lists[1]);
  EXPECT_EQ(lists[0], lists[2]);
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
