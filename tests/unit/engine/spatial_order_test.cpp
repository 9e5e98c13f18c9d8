// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/spatial_order.hpp"

#include "particles/box.hpp"
#include "tests/support/dimensions.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace plenum {
namespace {

template <class T>
class SpatialOrderTest : public testing::Test {};
TYPED_TEST_SUITE(SpatialOrderTest, test::Dimensions);

template <int Dim>
using Points = std::vector<Vec<Dim>>;

template <int Dim>
Points<Dim> randomPoints(std::size_t n, unsigned seed = 1) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Points<Dim> points(n);
  for (Vec<Dim>& x : points)
    for (int a = 0; a < Dim; ++a) x[a] = uniform(generator);
  return points;
}

template <int Dim>
Points<Dim> lattice(std::size_t n) {
  const auto perAxis =
      static_cast<std::size_t>(std::ceil(std::pow(static_cast<double>(n), 1.0 / Dim)));
  Points<Dim> points(n);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t rest = k;
    for (int a = 0; a < Dim; ++a, rest /= perAxis)
      points[k][a] = static_cast<double>(rest % perAxis);
  }
  return points;
}

template <int Dim>
Points<Dim> coincident(std::size_t n) {
  return Points<Dim>(n, Vec<Dim>::filled(0.7));
}

template <int Dim>
Points<Dim> onALine(std::size_t n) {
  Points<Dim> points = randomPoints<Dim>(n);
  for (Vec<Dim>& x : points)
    for (int a = 0; a < Dim; ++a) x[a] = a == Dim - 1 ? x[a] : 0.3;
  return points;
}

/// One in a thousand points far out, the others within a millionth of the way.
template <int Dim>
Points<Dim> clump(std::size_t n) {
  Points<Dim> points = randomPoints<Dim>(n);
  for (std::size_t k = 0; k < n; ++k)
    if (k % 1000 != 999) points[k] *= 1e-6;
  return points;
}

template <int Dim>
std::vector<std::uint32_t> orderBy(SpatialOrder<Dim>& spatialOrder, const Points<Dim>& points) {
  const std::size_t n = points.size();
  std::vector<std::uint32_t> order(n), work(n), more(n);
  spatialOrder.sort(points, order, work, more);
  return order;
}

template <int Dim>
std::vector<std::uint32_t> orderOf(const Points<Dim>& points) {
  SpatialOrder<Dim> spatialOrder;
  return orderBy<Dim>(spatialOrder, points);
}

template <int Dim>
void expectPermutation(const Points<Dim>& points) {
  std::vector<std::uint32_t> order = orderOf<Dim>(points);
  ASSERT_EQ(order.size(), points.size());
  std::ranges::sort(order);
  for (std::uint32_t k = 0; k < order.size(); ++k) ASSERT_EQ(order[k], k);
}

TYPED_TEST(SpatialOrderTest, KeepsEveryPointOnce) {
  constexpr int Dim = TypeParam::value;
  for (const std::size_t n : {0, 1, 7, 8, 9, 5000, 50000}) {
    SCOPED_TRACE(n);
    expectPermutation<Dim>(randomPoints<Dim>(n));
    expectPermutation<Dim>(lattice<Dim>(n));
    expectPermutation<Dim>(coincident<Dim>(n));
    expectPermutation<Dim>(onALine<Dim>(n));
    expectPermutation<Dim>(clump<Dim>(n));
  }
}

TYPED_TEST(SpatialOrderTest, CanBeUsedAgainForFewerAndMorePoints) {
  constexpr int Dim = TypeParam::value;
  SpatialOrder<Dim> order;
  for (const std::size_t n : {6000, 10, 0, 20000}) {
    const Points<Dim> points = randomPoints<Dim>(n);
    EXPECT_EQ(orderBy<Dim>(order, points), orderOf<Dim>(points));
  }
}

template <int Dim>
Box<Dim> boxOfCluster(const Points<Dim>& points, const std::vector<std::uint32_t>& order,
                      std::size_t first) {
  Box<Dim> box = Box<Dim>::nothing();
  for (std::size_t k = first; k < first + clusterSize; ++k) box.extend(points[order[k]]);
  return box;
}

/// Mean volume of the boxes of full clusters, in units of `volumePerPoint` x 8.
template <int Dim>
double meanVolume(const Points<Dim>& points, double volumePerPoint) {
  const std::vector<std::uint32_t> order = orderOf<Dim>(points);
  double sum = 0;
  std::size_t nClusters = 0;
  for (std::size_t first = 0; first + clusterSize <= order.size(); first += clusterSize) {
    sum += boxOfCluster<Dim>(points, order, first).volume();
    ++nClusters;
  }
  return sum / static_cast<double>(nClusters) / (volumePerPoint * clusterSize);
}

/// 90 % of the boxes of clusters of a set in the unit cube, but for a few strays, are below this
/// many times the volume of 8 points.
template <int Dim>
double mostVolumes(const Points<Dim>& points, const std::vector<std::uint32_t>& order) {
  const std::size_t n = points.size();
  std::vector<double> volumes;
  for (std::size_t first = 0; first + clusterSize <= n; first += clusterSize)
    volumes.push_back(boxOfCluster<Dim>(points, order, first).volume());
  std::ranges::sort(volumes);
  return volumes[volumes.size() * 9 / 10] * static_cast<double>(n) / clusterSize;
}

/// From cells of one Packer to such that must be divided; strays on a scale each, and in a bunch.
TYPED_TEST(SpatialOrderTest, AFewStraysDoNotSpoilTheOrderOfTheOthers) {
  constexpr int Dim = TypeParam::value;
  for (const std::size_t n : {1000, 4000, 20000, 60000})
    for (const std::size_t nStrays : {1, 4, 40})
      for (const double ratio : {1.0, 2.0, 5.0}) {
        if (100 * nStrays > n) continue;  // not a few
        Points<Dim> points = randomPoints<Dim>(n);
        for (std::size_t k = 0; k < nStrays; ++k)
          for (int a = 0; a < Dim; ++a)
            points[k * n / nStrays][a] +=
                (k % 3 == 2 ? -1e4 : 1e4) * std::pow(ratio, static_cast<double>(k));
        const double typical = mostVolumes<Dim>(points, orderOf<Dim>(points));
        // As of a clump with strays, below; and in a cell with strays bins may be three times as
        // wide, so that in 1-D twelve points share one.
        EXPECT_LT(typical, 3.0) << n << " points, " << nStrays << " strays, ratio " << ratio;
      }
}

/// Points in no order at all would have factors of n/8 and more.
TYPED_TEST(SpatialOrderTest, MakesCompactClusters) {
  constexpr int Dim = TypeParam::value;
  for (const std::size_t n : {4000, 30000}) {
    const double random = meanVolume<Dim>(randomPoints<Dim>(n), 1.0 / static_cast<double>(n));
    std::cout << "  " << n << " random points: mean box of a cluster / volume of 8 points "
              << random << "\n";
    // Eight random points span (7/9)^d of a cubic cell that holds eight. Here some clusters lie
    // across the ends of columns, one of 256 has points of two cells and may span both, and points
    // in a bin are not sorted: 1-D has up to four in each, half a cluster.
    EXPECT_LT(random, 1.5);
  }
  // A clump with strays is as compact: all but some of its clusters must be small.
  const std::size_t n = 20000;
  const Points<Dim> points = clump<Dim>(n);
  const std::vector<std::uint32_t> order = orderOf<Dim>(points);
  const double typical = mostVolumes<Dim>(points, order) / std::pow(1e-6, Dim);
  std::cout << "  a clump with strays: 90 % of the boxes below " << typical << "\n";
  // Boxes of random points vary; twice the mean of a uniform set is still a cluster.
  EXPECT_LT(typical, 2.0);
}

TYPED_TEST(SpatialOrderTest, IsTheSameForAnyNumberOfThreads) {
  constexpr int Dim = TypeParam::value;
  for (const Points<Dim>& points : {randomPoints<Dim>(40000), clump<Dim>(40000)}) {
    std::vector<std::vector<std::uint32_t>> orders;
    for (const int nThreads : {1, 2, 3}) {
      omp_set_num_threads(nThreads);
      orders.push_back(orderOf<Dim>(points));
    }
    omp_set_num_threads(omp_get_num_procs());
    EXPECT_EQ(orders[0], orders[1]);
    EXPECT_EQ(orders[0], orders[2]);
  }
}

}  // namespace
}  // namespace plenum
