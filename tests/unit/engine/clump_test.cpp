// SPDX-License-Identifier: GPL-3.0-or-later
//
// Particles crowded in a small part of the domain: what the search costs, and what the list does
// where there are more neighbours than its numbers hold.
#include "engine/engine.hpp"

#include "engine/pass_of.hpp"
#include "particles/errors.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/support/pair_sums.hpp"
#include "tests/support/random_particles.hpp"
#include "tests/support/threads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace plenum {
namespace {

template <class T>
class ClumpTest : public testing::Test {};
TYPED_TEST_SUITE(ClumpTest, test::Dimensions);

constexpr double clumpShare = 0.01;  // of the volume

/// Work and size of the list, a particle.
struct Cost {
  double tests, tiles, bytes;
};

/// Of n particles in the whole unit box or in a hundredth of it, with the same number of
/// neighbours.
template <int Dim>
Cost costOf(std::size_t n, bool periodic, double share) {
  const Box<Dim> box = test::unitBox<Dim>(periodic);
  const double edge = std::pow(share, 1.0 / Dim);
  auto particles = test::randomParticles<Dim>(box, n, 0);
  for (Vec<Dim>& x : particles[field::position]) x *= edge;
  Engine<Dim> engine(box, {3 * edge * std::pow(static_cast<double>(n), -1.0 / Dim), 0.2});
  engine.update(particles);
  const auto each = [&](std::size_t value) {
    return static_cast<double>(value) / static_cast<double>(n);
  };
  return {each(engine.tiles().nTests()), each(engine.tiles().nTiles()), each(engine.bytes())};
}

/// A search of all pairs would do sixteen times the work a particle for sixteen times as many.
TYPED_TEST(ClumpTest, TheSearchCostsTheSameForEachParticleOfAClump) {
  constexpr int Dim = TypeParam::value;
  // Without a surface, where particles have fewer neighbours than elsewhere: the most.
  const double most = costOf<Dim>(8000, true, 1).tests;
  for (const bool periodic : {false, true}) {
    std::vector<Cost> clump, spread;
    for (const std::size_t n : {8000, 32000, 128000}) {
      clump.push_back(costOf<Dim>(n, periodic, clumpShare));
      spread.push_back(costOf<Dim>(n, periodic, 1));
      std::cout << "  " << n << (periodic ? " periodic" : " open") << ": tests a particle "
                << clump.back().tests << " (spread " << spread.back().tests << "), tiles "
                << clump.back().tiles << " (" << spread.back().tiles << "), bytes "
                << clump.back().bytes << " (" << spread.back().bytes << ")\n";
    }
    for (std::size_t k = 0; k < clump.size(); ++k) {
      // How far the last chunk is filled, and how cells divide, makes some tenths.
      EXPECT_LE(clump[k].tests, 1.25 * most);
      // Scaled positions are in the same order; what the search rounds to float differs by a tile
      // here and there. In a periodic box a clump has fewer neighbours than a full box.
      EXPECT_LE(clump[k].tests, 1.05 * spread[k].tests);
      EXPECT_LE(clump[k].tiles, 1.01 * spread[k].tiles);
      EXPECT_LE(clump[k].bytes, 1.05 * spread[k].bytes);
    }
  }
}

/// How wrong the sums of half the particles in a tiny clump and half around it are, relative to
/// their typical size.
template <int Dim>
double deviationOfTwoScales(Precision precision, bool periodic, double clumpSize) {
  const Box<Dim> box = test::unitBox<Dim>(periodic);
  auto particles = test::randomParticles<Dim>(box, 800, 0);
  const auto x = particles[field::position];
  for (std::size_t i = 0; i < x.size(); i += 2)
    x[i] = Vec<Dim>::filled(0.3) + clumpSize * (x[i] - Vec<Dim>::filled(0.3));
  const double support = 0.2;
  const Pass<kernel::WendlandC2, test::GradientProbe> pass{{}, 0.5 * support, {}};
  Engine<Dim> engine(box, {support, 0.2, false, precision});
  engine.update(particles);
  engine.run(passOf<Dim>(pass), particles);
  return test::worstDeviation(
      engine, pass.writes, particles,
      test::sumOfAllPairs<Dim>(pass, particles, box, Group::fluids, Group::all), Group::fluids);
}

TYPED_TEST(ClumpTest, SumsOfATinyClumpInASparseGasAreRight) {
  constexpr int Dim = TypeParam::value;
  for (const bool periodic : {false, true})
    for (const double size : {0.1, 1e-6, 0.0})
      for (const Precision precision : test::bothPrecisions) {
        // Up to ten times as many terms a sum as in pair_loop_test.cpp: their roundings add up like
        // a random walk at best, three times, and in proportion at worst.
        const double tolerance = precision == Precision::mixed ? 5e-5 : 5e-13;
        EXPECT_LE(deviationOfTwoScales<Dim>(precision, periodic, size), tolerance)
            << test::nameOf(precision) << ", size " << size << ", periodic " << periodic;
      }
}

/// Copies of one small scene, too far from each other to see each other: few particles of fluid,
/// each among many of a wall. Together they see more clusters than one chunk can tell apart.
struct ManySites {
  static constexpr std::size_t nSites = 256, nFluid = clusterSize, nWalls = 2112;
  static constexpr double distance = 10, support = 1;
  Box<2> box = test::unitBox<2>(false);
  ParticleSet<2> one, all;

  ManySites() {
    one = test::randomParticles<2>(box, nFluid, nWalls);
    for (auto& x : one[field::position]) x *= 0.5;  // all within the support of each other
    all = test::randomParticles<2>(box, nSites * nFluid, nSites * nWalls);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool isFluid = i < all.nFluid();
      const std::size_t local = isFluid ? i : i - all.nFluid(), nEach = isFluid ? nFluid : nWalls;
      const std::size_t site = local / nEach, source = local % nEach + (isFluid ? 0 : nFluid);
      all[field::position][i] =
          one[field::position][source] +
          distance * Vec<2>{{static_cast<double>(site % 16), static_cast<double>(site / 16)}};
      all[field::mass][i] = one[field::mass][source];
      all[field::id][i] = source;
    }
  }
};

TEST(Clump, ChunksThatSeeTooManyClustersAreMadeSmaller) {
  ManySites sites;
  const Pass<kernel::WendlandC2, test::GradientProbe> pass{{}, 0.5 * sites.support, {}};
  const auto expected =
      test::sumOfAllPairs<2>(pass, sites.one, sites.box, Group::fluids, Group::all);
  Engine<2> engine(sites.box, {sites.support, 0.2, false, Precision::doubled});
  engine.update(sites.all);
  EXPECT_GT(engine.tiles().chunks().size(), 1u);  // 256 clusters of fluid would be one
  engine.run(passOf<2>(pass), sites.all);
  const auto sums = engine.sums(field::density);
  const double typical = expected.typicalSize(0, 0, sites.nFluid);
  for (std::size_t i = 0; i < sites.all.nFluid(); ++i) {
    const auto row = static_cast<std::size_t>(expected.nOut) * sites.all[field::id][i];
    // 2100 additions of 1.1e-16 each at most, and positions up to 160 m that are rounded to
    // 1.4e-14 m twice, in h = .5 m.
    EXPECT_NEAR(sums[i], static_cast<double>(expected.value[row]), 5e-13 * typical);
  }
}

/// All in one place: no chunk can be so small that 16 bits tell apart whom it sees.
TEST(Clump, MoreNeighboursThanTheListCanNumberAreAnError) {
  const Box<1> box = test::unitBox<1>(false);
  const auto messages = test::forThreads([&] {
    auto particles = test::randomParticles<1>(box, 1000, 0);
    Engine<1> engine(box, {0.1, 0.2});
    engine.update(particles);
    particles = ParticleSet<1>({field::position, field::mass}, 600000, 0);
    std::ranges::fill(particles[field::position], Vec<1>::filled(0.5));
    std::string message;
    // Once refused, the set is not taken for one that was searched.
    for (int attempt = 0; attempt < 2; ++attempt) try {
        engine.update(particles);
        ADD_FAILURE() << "no error";
      } catch (const RunError& error) {
        message = error.what();
      }
    // The list that was given up may not fill the memory: the sort takes 52 bytes a particle.
    EXPECT_LT(engine.bytes(), 100 * particles.size());
    return message;
  });
  EXPECT_NE(messages[0].find("neighbours"), std::string::npos) << messages[0];
  EXPECT_EQ(messages[0], messages[1]);
  EXPECT_EQ(messages[0], messages[2]);
}

}  // namespace
}  // namespace plenum
