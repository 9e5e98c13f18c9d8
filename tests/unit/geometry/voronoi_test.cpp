// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/voronoi.hpp"

#include "tests/support/threads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

namespace plenum {
namespace {

template <int Dim>
using Points = std::vector<Vec<Dim>>;

template <int Dim>
Box<Dim> periodicBox(const Vec<Dim>& lower, const Vec<Dim>& extent) {
  Box<Dim> box{lower, lower + extent, {}};
  box.periodic.fill(true);
  return box;
}

template <int Dim>
Points<Dim> randomPoints(const Box<Dim>& box, std::size_t n) {
  std::mt19937_64 generator(7);
  Points<Dim> points(n);
  for (Vec<Dim>& x : points)
    for (int a = 0; a < Dim; ++a)
      x[a] = box.lower[a] + box.extent()[a] * static_cast<double>(generator() >> 11) * 0x1p-53;
  return points;
}

/// `basis` repeated in n^Dim cells with edges `cell`, from `lower` on.
template <int Dim>
Points<Dim> lattice(const Vec<Dim>& lower, const Vec<Dim>& cell, int n, const Points<Dim>& basis) {
  Points<Dim> points;
  for (int k = 0; k < static_cast<int>(std::pow(n, Dim) + 0.5); ++k)
    for (const Vec<Dim>& offset : basis) {
      Vec<Dim> x = lower;
      for (int a = 0, rest = k; a < Dim; ++a, rest /= n) x[a] += (rest % n + offset[a]) * cell[a];
      points.push_back(x);
    }
  return points;
}

/// Corners of cells are right to some 1e-13 of their edges even for slivers; volumes and centroids
/// add up some dozen of them.
constexpr double cornerRoundOff = 1e-12;

template <int Dim>
void expectLatticeCells(const std::vector<VoronoiCell<Dim>>& cells, const Points<Dim>& points,
                        double volume) {
  const double spacing = std::pow(volume, 1.0 / Dim);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    ASSERT_NEAR(cells[i].volume, volume, cornerRoundOff * volume) << i;
    ASSERT_NEAR(norm(cells[i].centroid - points[i]), 0, cornerRoundOff * spacing) << i;
  }
}

/// All cells of a lattice that fills a periodic box.
template <int Dim>
void expectLatticeCells(const Vec<Dim>& cell, const Points<Dim>& basis) {
  const Vec<Dim> lower = Vec<Dim>::filled(-0.3);
  const int n = 5;
  // The first points must lie in the box, not on its upper faces; a lattice may begin anywhere.
  const Points<Dim> points = lattice<Dim>(lower, cell, n, basis);
  const Box<Dim> box = periodicBox<Dim>(lower, n * cell);
  expectLatticeCells<Dim>(voronoiCells<Dim>({points, points.size()}, box, 0.2), points,
                          box.volume() / static_cast<double>(points.size()));
}

constexpr double root3 = std::numbers::sqrt3;

TEST(Voronoi, CellsOfLatticesAreThoseOfTheLattice) {
  for (const double d : {0.1, 0.125}) {  // round-off in the coordinates, and none
    expectLatticeCells<1>({{d}}, {{{0.5}}});
    expectLatticeCells<2>({{d, d}}, {{{0.5, 0.5}}});
    expectLatticeCells<2>({{d, root3 * d}}, {{{0.25, 0.25}}, {{0.75, 0.75}}});
    expectLatticeCells<3>({{d, d, d}}, {{{0.5, 0.5, 0.5}}});
    expectLatticeCells<3>({{d, d, d}}, {{{0.25, 0.25, 0.25}}, {{0.75, 0.75, 0.75}}});  // bcc
    expectLatticeCells<3>({{d, d, d}}, {{{0.25, 0.25, 0.25}},                          // fcc
                                        {{0.75, 0.75, 0.25}},
                                        {{0.75, 0.25, 0.75}},
                                        {{0.25, 0.75, 0.75}}});
  }
}

TEST(Voronoi, ATurnedCubicLatticeHasItsCellsToo) {
  // Eight points on each empty sphere, up to round-off: the triangulation is full of slivers.
  const double d = 0.1, c = std::cos(0.7), s = std::sin(0.7);
  Points<3> inner, outer;
  for (const Vec<3>& x : lattice<3>({{-4 * d, -4 * d, -4 * d}}, {{d, d, d}}, 9, {{{0, 0, 0}}})) {
    const Vec<3> about = {{c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]}};
    const Vec<3> turned = {{about[0], c * about[1] - s * about[2], s * about[1] + c * about[2]}};
    (norm(x) < 2.9 * d ? inner : outer).push_back(turned);
  }
  Points<3> points = inner;
  points.insert(points.end(), outer.begin(), outer.end());
  const auto cells = voronoiCells<3>({points, inner.size()});
  ASSERT_GT(cells.size(), 50u);
  expectLatticeCells<3>(cells, points, d * d * d);
}

TEST(Voronoi, ABrickAroundAPoint) {
  const Points<3> points = {{{0, 0, 0}},  {{2, 0, 0}}, {{-4, 0, 0}}, {{0, 6, 0}},
                            {{0, -2, 0}}, {{0, 0, 1}}, {{0, 0, -1}}};
  const auto cells = voronoiCells<3>({points, 1});  // [-2, 1] x [-1, 3] x [-.5, .5]
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_NEAR(cells[0].volume, 12, 12 * cornerRoundOff);
  EXPECT_NEAR(norm(cells[0].centroid - Vec<3>{{-0.5, 1, 0}}), 0, 3 * cornerRoundOff);
}

template <int Dim>
void expectVolumesToAddUp(std::size_t n) {
  Vec<Dim> extent = Vec<Dim>::filled(0.5);
  extent[0] = 1;
  const Box<Dim> box = periodicBox<Dim>(Vec<Dim>::filled(3), extent);
  const Points<Dim> points = randomPoints(box, n);
  // A margin of next to nothing grows until no image is missing.
  for (const double margin : {1e-3, 0.1, 0.6}) {
    double sum = 0;
    for (const auto& cell : voronoiCells<Dim>({points, n}, box, margin)) sum += cell.volume;
    EXPECT_NEAR(sum, box.volume(), 1e-11 * box.volume()) << n << " points, margin " << margin;
  }
}

TEST(Voronoi, VolumesOfRandomPointsAddUpToTheBox) {
  // Errors of corners, 2e-13 of the edges of a simplex, that two cells share cancel; what is left
  // is their distance from a facet's plane, ten times round-off of the largest empty sphere.
  for (const std::size_t n : {1, 2, 5, 100, 1000}) {
    expectVolumesToAddUp<1>(n);
    expectVolumesToAddUp<2>(n);
    expectVolumesToAddUp<3>(n);
  }
}

/// Centroids by asking for the nearest generator on a fine grid.
Points<2> centroidsOnAGrid(const Points<2>& points, const Box<2>& box, const Vec<2>& slope, int n) {
  Points<2> moments(points.size());
  std::vector<double> weights(points.size());
  for (int k = 0; k < n * n; ++k) {
    const Vec<2> x{{(k % n + 0.5) / n, (k / n + 0.5) / n}};
    std::size_t nearest = 0;
    Vec<2> from = Vec<2>::filled(std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec<2> r = box.nearestImage(x - points[i]);
      if (normSquared(r) < normSquared(from)) from = r, nearest = i;
    }
    const double w = std::exp(dot(slope, from));
    weights[nearest] += w;
    moments[nearest] += w * from;
  }
  for (std::size_t i = 0; i < points.size(); ++i) moments[i] = points[i] + moments[i] / weights[i];
  return moments;
}

TEST(Voronoi, CentroidsAreThoseOfAFineGrid) {
  const Box<2> box = periodicBox<2>({{0, 0}}, {{1, 1}});
  const Points<2> points = randomPoints(box, 30);
  const auto cells = voronoiCells<2>({points, points.size()}, box, 0.5);
  const int n = 500;
  const Points<2> expected = centroidsOnAGrid(points, box, {{0, 0}}, n);
  for (std::size_t i = 0; i < points.size(); ++i)
    // A cell of a diameter of .2 has some 400 grid cells on its rim that are in or out as a whole,
    // each 1 / n^2, of 8000: sqrt(400)/8000 * .2/2 = 2.5e-4, and four times that for the smallest.
    EXPECT_NEAR(norm(cells[i].centroid - expected[i]), 0, 1e-3) << i;
}

TEST(Voronoi, WeightsDrawCentroidsAsTheirIntegralsSay) {
  const Vec<2> slope{{2, -1}};
  const Box<2> box = periodicBox<2>({{0, 0}}, {{1, 1}});
  const Points<2> wanted = randomPoints(box, 30);
  // ln w goes on beyond the faces, so images are made here.
  Points<2> points = wanted;
  for (int k = 0; k < 9; ++k)
    for (const Vec<2>& x : wanted)
      if (k != 4) points.push_back(x + Vec<2>{{k % 3 - 1.0, k / 3 - 1.0}});
  std::vector<double> logWeights;
  for (const Vec<2>& x : points) logWeights.push_back(5 + dot(slope, x));  // 5: ratios only matter
  const auto cells = voronoiCells<2>({points, wanted.size(), logWeights});
  const auto even = voronoiCells<2>({points, wanted.size()});
  const Points<2> expected = centroidsOnAGrid(wanted, box, slope, 500);
  double drawn = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    // The grid's 1e-3 as above; w taken as linear across simplices of .1 errs by (.2)^2/8 of it,
    // half a percent of what moves a centroid at all (.02).
    EXPECT_NEAR(norm(cells[i].centroid - expected[i]), 0, 1.1e-3) << i;
    EXPECT_EQ(cells[i].volume, even[i].volume);
    drawn += normSquared(cells[i].centroid - even[i].centroid);
  }
  // The bound sees the weights: without them it would be missed by far.
  EXPECT_GT(std::sqrt(drawn / static_cast<double>(wanted.size())), 4e-3);
}

TEST(Voronoi, AGradientOfWeightsIsFoundOnALine) {
  // Cells of 1 m, ln w = x: int x e^x / int e^x over [-.5, .5] = .0826; the trapezia of w linear
  // on both halves give (e^.5 - e^-.5)/12 / ((e^.5 + e^-.5 + 2)/4) = .0816.
  const Points<1> points = {{{0}}, {{-1}}, {{1}}};
  const std::vector<double> logWeights = {0, -1, 1};
  const auto cells = voronoiCells<1>({points, 1, logWeights});
  const double rise = std::exp(0.5) - std::exp(-0.5), sum = std::exp(0.5) + std::exp(-0.5);
  EXPECT_NEAR(cells[0].centroid[0], rise / 12 / ((sum + 2) / 4), 1e-15);  // round-off
}

TEST(Voronoi, HugeContrastsOfWeightsStayInTheCell) {
  const Box<3> box = periodicBox<3>({{0, 0, 0}}, {{1, 1, 1}});
  const Points<3> points = randomPoints(box, 500);
  std::vector<double> logWeights;
  for (const Vec<3>& x : points) logWeights.push_back(x[0] < 0.5 ? 0 : 600);  // 1 : 1e260
  const auto cells = voronoiCells<3>({points, points.size(), logWeights}, box, 0.3);
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j)  // NaN fails, too
      ASSERT_LE(norm(cells[i].centroid - points[i]),
                norm(points[i] + box.nearestImage(points[j] - points[i]) - cells[i].centroid) +
                    1e-12);  // round-off
}

TEST(Voronoi, OfCoincidentPointsOneHasTheCell) {
  const Box<2> box = periodicBox<2>({{0, 0}}, {{1, 1}});
  Points<2> points = randomPoints(box, 50);
  points.push_back(points[3]);
  const auto cells = voronoiCells<2>({points, points.size()}, box, 0.3);
  EXPECT_EQ(std::min(cells[3].volume, cells[50].volume), 0);
  EXPECT_GT(std::max(cells[3].volume, cells[50].volume), 0);
  EXPECT_EQ((cells[3].volume == 0 ? cells[3] : cells[50]).centroid, points[3]);
}

TEST(Voronoi, RefusesCellsThatReachInfinity) {
  const Points<2> square = {{{0, 0}}, {{1, 0}}, {{0, 1}}, {{1, 1}}, {{0.5, 0.5}}};
  EXPECT_THROW(voronoiCells<2>({square, 1}), std::invalid_argument);
  EXPECT_THROW(voronoiCells<2>({square, 6}), std::invalid_argument);
  EXPECT_THROW(voronoiCells<2>({std::span(square).first(1), 1}), std::invalid_argument);
  EXPECT_THROW(voronoiCells<1>({Points<1>{{{0.0}}, {{1.0}}}, 1}), std::invalid_argument);
  const Points<3> flat = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{-1, -1, 0}}};
  EXPECT_THROW(voronoiCells<3>({flat, 1}), std::invalid_argument);
  const std::vector<double> one = {1};
  EXPECT_THROW(voronoiCells<3>({flat, 0, one}), std::invalid_argument);
  EXPECT_TRUE(voronoiCells<3>({flat, 0}).empty());
  const Points<1> lost = {{{std::nan("")}}, {{1.0}}};
  EXPECT_THROW(voronoiCells<1>({lost, 1}), std::invalid_argument);
}

TEST(Voronoi, DoesNotDependOnTheNumberOfThreads) {
  const Box<3> box = periodicBox<3>({{0, 0, 0}}, {{1, 1, 1}});
  const Points<3> points = randomPoints(box, 2 * 8192);  // more than what one thread would do alone
  const auto results = test::forThreads([&] {
    return voronoiCells<3>({points, points.size()}, box, 0.1);
  });
  for (const auto& cells : results)
    for (std::size_t i = 0; i < cells.size(); ++i) {
      ASSERT_EQ(cells[i].volume, results.front()[i].volume);
      ASSERT_EQ(cells[i].centroid, results.front()[i].centroid);
    }
}

}  // namespace
}  // namespace plenum
