// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every pair of neighbours must be in exactly one tile, in the role that gives both their sums.
#include "engine/tile_list.hpp"

#include "engine/engine.hpp"
#include "engine/pass_of.hpp"
#include "engine/periodicity.hpp"
#include "tests/support/dimensions.hpp"
#include "tests/support/pair_sums.hpp"
#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <array>
#include <cmath>
#include <compare>

namespace plenum {
namespace {

template <class T>
class TileListTest : public testing::Test {};
TYPED_TEST_SUITE(TileListTest, test::Dimensions);

/// Receiver i gets something from source j, which is seen `image` periods away.
template <int Dim>
struct Gift {
  std::size_t i, j;
  std::array<int, Dim> image;
  auto operator<=>(const Gift&) const = default;
};

template <int Dim>
using Gifts = std::vector<Gift<Dim>>;

template <int Dim>
Gift<Dim> opposite(Gift<Dim> gift) {
  std::swap(gift.i, gift.j);
  for (int& n : gift.image) n = -n;
  return gift;
}

/// Particles in the order of clusters, and the box they are in.
template <int Dim>
struct Sample {
  Box<Dim> domain;
  std::vector<Vec<Dim>> positions;
  std::vector<double> reach;  // of each particle
  Clusters<Dim> clusters = {};
  std::vector<ClusterBox<Dim>> boxes = {};
};

template <int Dim>
void placeClusters(Sample<Dim>& sample, std::size_t nFluid) {
  const std::size_t ends[] = {nFluid, sample.positions.size() - nFluid};
  sample.clusters.clear();
  sample.clusters.append(std::span(ends).first(1), true);
  sample.clusters.append(std::span(ends).last(1), false);
  sample.boxes.resize(sample.clusters.nClusters);
  sample.clusters.place(
      sample.positions, sample.domain, [&](std::size_t i) { return sample.reach[i]; },
      sample.boxes);
}

template <int Dim>
Sample<Dim> sampleOf(const Box<Dim>& domain, std::size_t nFluid, std::size_t nWalls,
                     double radius) {
  auto particles = test::randomParticles<Dim>(domain, nFluid, nWalls);
  // Sorting changes nothing about what is right, only how many tiles there are.
  Engine<Dim> engine(domain, {1e-3, 0.2, false, Precision::doubled});
  engine.update(particles);
  Sample<Dim> sample{domain, {}, {}};
  const auto x = particles[field::position];
  sample.positions.assign(x.begin(), x.end());
  sample.reach.assign(x.size(), radius);
  placeClusters(sample, nFluid);
  return sample;
}

/// All that tiles give, or only those that are counted as near. Positions are as the loop sees
/// them: relative to the clusters of the list's own positions.
template <int Dim>
Gifts<Dim> giftsOf(const TileList<Dim>& list, const Sample<Dim>& sample, bool wallsReceive,
                   bool onlyNear) {
  Gifts<Dim> gifts;
  const Clusters<Dim>& clusters = sample.clusters;
  const auto visit = [&](const LocalCluster<Dim>& own, std::size_t half,
                         const LocalCluster<Dim>& other, bool bothWays) {
    Gift<Dim> gift;
    for (int a = 0; a < Dim; ++a) {
      const double shift = (other.origin[a] - clusters.origin[other.cluster][a]) -
                           (own.origin[a] - clusters.origin[own.cluster][a]);
      const double period = sample.domain.upper[a] - sample.domain.lower[a];
      gift.image[static_cast<std::size_t>(a)] = static_cast<int>(std::lround(shift / period));
    }
    const std::size_t first = clusters.firstOf(own.cluster) + half * clusterSize / 2;
    const std::size_t last = std::min(first + clusterSize / 2, clusters.endOf(own.cluster));
    for (gift.i = first; gift.i < last; ++gift.i)
      for (gift.j = clusters.firstOf(other.cluster); gift.j < clusters.endOf(other.cluster);
           ++gift.j) {
        gifts.push_back(gift);
        if (bothWays) gifts.push_back(opposite(gift));
      }
  };
  for (const TileChunk<Dim>& chunk : list.chunks()) {
    const auto* tile = chunk.tiles.data();
    for (std::size_t half = 0; half < 2 * chunk.nClusters; ++half) {
      const LocalCluster<Dim>& own = chunk.locals[half / 2];
      const TileCounts& count = chunk.counts[half];
      const auto visitKind = [&](std::uint32_t all, std::uint32_t near, bool bothWays) {
        EXPECT_LE(near, all);
        for (std::uint32_t k = 0; k < (onlyNear ? near : all); ++k)
          visit(own, half % 2, chunk.locals[tile[k]], bothWays);
        tile += all;
      };
      visitKind(count.self, count.nearSelf, false);
      visitKind(count.fluid, count.nearFluid, true);
      visitKind(count.wall, count.nearWall, wallsReceive);
    }
    EXPECT_EQ(tile, chunk.tiles.data() + chunk.tiles.size());
  }
  std::ranges::sort(gifts);
  return gifts;
}

/// Every pair closer than the larger reach of the two, by search of all images of all particles.
template <int Dim>
Gifts<Dim> expectedGifts(const Sample<Dim>& sample, std::span<const Vec<Dim>> positions,
                         bool wallsReceive) {
  Gifts<Dim> gifts;
  const std::size_t nReceivers = wallsReceive ? positions.size() : sample.clusters.nFluid;
  int nImages = 1;
  for (int a = 0; a < Dim; ++a) nImages *= sample.domain.isPeriodic(a) ? 3 : 1;
  for (std::size_t i = 0; i < nReceivers; ++i)
    for (std::size_t j = 0; j < positions.size(); ++j)
      for (int image = 0; image < nImages; ++image) {
        Gift<Dim> gift{i, j, {}};
        Vec<Dim> shift;
        for (int a = 0, rest = image; a < Dim; ++a) {
          if (!sample.domain.isPeriodic(a)) continue;
          const int n = rest % 3 - 1;
          rest /= 3;
          gift.image[static_cast<std::size_t>(a)] = n;
          shift[a] = n * (sample.domain.upper[a] - sample.domain.lower[a]);
        }
        if (norm(positions[j] + shift - positions[i]) < std::max(sample.reach[i], sample.reach[j]))
          gifts.push_back(gift);
      }
  std::ranges::sort(gifts);
  return gifts;
}

template <int Dim>
void expectOnce(const Gifts<Dim>& gifts, const Gifts<Dim>& expected) {
  EXPECT_EQ(std::ranges::adjacent_find(gifts), gifts.end()) << "a pair is computed twice";
  EXPECT_TRUE(std::ranges::includes(gifts, expected)) << "a pair is missing";
}

template <int Dim>
void expectComplete(const Sample<Dim>& sample) {
  for (const bool wallsReceive : {false, true}) {
    SCOPED_TRACE(testing::Message()
                 << sample.clusters.nFluid << " fluid of " << sample.positions.size()
                 << " particles, reach of the first " << sample.reach.front() << ", periodic "
                 << sample.domain.anyPeriodic() << ", walls receive " << wallsReceive);
    TileList<Dim> list;
    list.build(sample.positions, sample.clusters, sample.domain, 1, wallsReceive);
    expectOnce(giftsOf(list, sample, wallsReceive, false),
               expectedGifts<Dim>(sample, sample.positions, wallsReceive));
  }
}

template <int Dim>
void expectComplete(const Box<Dim>& domain, std::size_t nFluid, std::size_t nWalls, double radius) {
  expectComplete(sampleOf<Dim>(domain, nFluid, nWalls, radius));
}

TYPED_TEST(TileListTest, HoldsEveryPairOnce) {
  constexpr int Dim = TypeParam::value;
  for (const bool periodic : {false, true}) {
    const Box<Dim> domain = test::unitBox<Dim>(periodic);
    for (const std::size_t nFluid : {0, 1, 2, 9, 300})
      for (const std::size_t nWalls : {0, 1, 2, 9, 300}) {
        if (nFluid + nWalls == 0) continue;
        // 0.6: a box of two supports, each with a fifth of it as skin.
        for (const double radius : {0.6, 0.3, 0.1})
          expectComplete<Dim>(domain, nFluid, nWalls, radius);
      }
  }
}

/// Several chunks of fluid (256 clusters each, 512 in 3-D), and of walls but for 3-D.
TYPED_TEST(TileListTest, HoldsEveryPairOnceInManyChunks) {
  constexpr int Dim = TypeParam::value;
  for (const bool periodic : {false, true}) {
    const auto sample = sampleOf<Dim>(test::unitBox<Dim>(periodic), 4500, Dim == 3 ? 600 : 2200,
                                      Dim == 1 ? 0.02 : 0.1);
    TileList<Dim> list;
    list.build(sample.positions, sample.clusters, sample.domain, 1, true);
    ASSERT_GT(list.nFluidChunks(), 1u);
    expectComplete(sample);
  }
}

/// Reaches of 1 : 100, neighbours' as different as those far apart.
TYPED_TEST(TileListTest, HoldsEveryPairOnceWithAnyReaches) {
  constexpr int Dim = TypeParam::value;
  for (const bool periodic : {false, true}) {
    Sample<Dim> sample = sampleOf<Dim>(test::unitBox<Dim>(periodic), 1200, 300, 0);
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (double& reach : sample.reach) reach = 0.6 * std::pow(0.01, uniform(generator));
    placeClusters(sample, sample.clusters.nFluid);
    expectComplete(sample);
  }
}

TYPED_TEST(TileListTest, HoldsEveryPairOnceWhenOneAxisIsPeriodic) {
  constexpr int Dim = TypeParam::value;
  Box<Dim> domain = test::unitBox<Dim>(false);
  domain.lower = Vec<Dim>::filled(-3);  // not at the origin
  domain.upper = Vec<Dim>::filled(-2);
  domain.periodic[Dim - 1] = true;
  for (const double radius : {0.6, 0.1}) expectComplete<Dim>(domain, 300, 100, radius);
}

TYPED_TEST(TileListTest, HoldsEveryPairOnceFarFromTheOrigin) {
  constexpr int Dim = TypeParam::value;
  Box<Dim> domain = test::unitBox<Dim>(false);
  domain.lower = Vec<Dim>::filled(1e6);
  domain.upper = Vec<Dim>::filled(1e6 + 1);
  expectComplete<Dim>(domain, 300, 100, 0.2);
}

/// What is near is found anew at every update, for the positions of that moment.
TYPED_TEST(TileListTest, NearTilesHoldEveryPairInTheSupportWhileParticlesMove) {
  constexpr int Dim = TypeParam::value;
  for (const bool periodic : {false, true})
    for (const Precision precision : {Precision::mixed, Precision::doubled})
      for (const double support : {0.5, 0.2}) {
        const Box<Dim> domain = test::unitBox<Dim>(periodic);
        auto particles = test::randomParticles<Dim>(domain, 300, 100);
        Engine<Dim> engine(domain, {support, 0.2, true, precision});
        std::mt19937_64 generator(5);
        std::uniform_real_distribution<double> uniform(-1, 1);
        Sample<Dim> sample{domain, {}, {}};
        for (int step = 0; step < 12; ++step) {
          const auto x = particles[field::position];
          if (engine.update(particles)) {
            sample.positions.assign(x.begin(), x.end());
            sample.reach.assign(x.size(), support);
            placeClusters(sample, particles.nFluid());
          }
          // Images as the clusters of the list have them.
          const Periodicity<Dim> periodicity(domain);
          std::vector<Vec<Dim>> present(x.begin(), x.end());
          for (std::size_t i = 0; i < present.size(); ++i)
            present[i] = sample.positions[i] + periodicity.nearestImage(x[i] - sample.positions[i]);
          expectOnce(giftsOf(engine.tiles(), sample, true, true),
                     expectedGifts<Dim>(sample, present, true));
          const double distance = 0.02 * support;
          for (Vec<Dim>& position : particles[field::position])
            for (int a = 0; a < Dim; ++a)
              position[a] += distance / std::sqrt(Dim) * uniform(generator);
          engine.moved(distance);
        }
        // Half the skin is a tenth of the support: five steps. (A small box may need more.)
        EXPECT_GE(engine.nRebuilds(), 2u);
      }
}

TYPED_TEST(TileListTest, IsTheSameForAnyNumberOfThreads) {
  constexpr int Dim = TypeParam::value;
  const Sample<Dim> sample = sampleOf<Dim>(test::unitBox<Dim>(true), 5000, 2000, 0.1);
  std::vector<std::vector<std::uint32_t>> lists;
  for (const int nThreads : {1, 2, 3}) {
    omp_set_num_threads(nThreads);
    TileList<Dim> list;
    list.build(sample.positions, sample.clusters, sample.domain, 1, true);
    std::vector<std::uint32_t> all;
    for (const TileChunk<Dim>& chunk : list.chunks()) {
      for (const auto tile : chunk.tiles) {
        all.push_back(chunk.locals[tile].cluster);
        all.push_back(chunk.locals[tile].sums);
      }
      const auto index = static_cast<std::size_t>(&chunk - list.chunks().data());
      for (const auto& addition : list.additionsTo(index)) {
        all.push_back(addition.to);
        all.push_back(addition.from);
      }
    }
    lists.push_back(all);
  }
  omp_set_num_threads(omp_get_num_procs());
  EXPECT_EQ(lists[0], lists[1]);
  EXPECT_EQ(lists[0], lists[2]);
}

}  // namespace
}  // namespace plenum
