// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/fill.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

constexpr std::size_t rowsPerBatch = 64;
constexpr std::size_t pointsPerBatch = 4096;

/// A run of neighbouring points in a row that are kept.
struct Run {
  std::int64_t begin;
  std::int64_t end;
};

/// How many points from here on are surely on the same side of the band, this one included.
/// Signed distances change by at most the distance moved.
std::int64_t sureSteps(double slack, double edge, std::int64_t left) {
  if (!(slack < edge * static_cast<double>(left))) return left;  // also without any surface
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(slack / edge * (1 - 1e-9)) + 1);
}

/// Marches `rows` together, so that each round asks the geometry for one batch of points.
template <int Dim>
std::vector<Vec<Dim>> march(std::span<const LatticeRow<Dim>> rows, const Geometry<Dim>& geometry,
                            DistanceBand band) {
  std::vector<std::int64_t> at(rows.size(), 0);
  std::vector<std::vector<Run>> runs(rows.size());
  std::vector<std::size_t> active(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) active[r] = r;
  std::vector<Vec<Dim>> points;
  std::vector<double> distances;
  while (!active.empty()) {
    points.clear();
    for (std::size_t r : active) points.push_back(rows[r].point(at[r]));
    distances.resize(points.size());
    geometry.signedDistance(points, distances);
    for (std::size_t k = 0; k < active.size(); ++k) {
      const std::size_t r = active[k];
      const double inward = std::min(distances[k] - band.lower, band.upper - distances[k]);
      const std::int64_t steps = sureSteps(std::abs(inward), rows[r].edge, rows[r].count - at[r]);
      if (inward >= 0) runs[r].push_back({at[r], at[r] + steps});
      at[r] += steps;
    }
    std::erase_if(active, [&](std::size_t r) { return at[r] >= rows[r].count; });
  }
  std::vector<Vec<Dim>> kept;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const Run& run : runs[r])
      for (std::int64_t i = run.begin; i < run.end; ++i) kept.push_back(rows[r].point(i));
  return kept;
}

/// A point a rounding error below a periodic face stands on it.
template <int Dim>
void wrapInto(const Box<Dim>& box, std::vector<Vec<Dim>>& points) {
  if (!box.anyPeriodic()) return;
  for (Vec<Dim>& x : points)
    for (int a = 0; a < Dim; ++a)
      if (box.isPeriodic(a) && x[a] < box.lower[a]) x[a] = box.lower[a];
}

/// Calls `query(first, count)` for slices of `n` points from all threads.
template <class Query>
void inBatches(std::size_t n, Query&& query) {
  parallelFor((n + pointsPerBatch - 1) / pointsPerBatch, [&](std::size_t batch) {
    const std::size_t first = batch * pointsPerBatch;
    query(first, std::min(pointsPerBatch, n - first));
  });
}

}  // namespace

template <int Dim>
std::vector<Vec<Dim>> latticePoints(const Lattice<Dim>& lattice, const Box<Dim>& box) {
  std::vector<Vec<Dim>> points;
  for (const LatticeRow<Dim>& row : lattice.rows(box))
    for (std::int64_t i = 0; i < row.count; ++i) points.push_back(row.point(i));
  wrapInto(box, points);
  return points;
}

template <int Dim>
std::vector<Vec<Dim>> latticePoints(const Lattice<Dim>& lattice, const Box<Dim>& box,
                                    const Geometry<Dim>& geometry, DistanceBand band) {
  const std::vector<LatticeRow<Dim>> rows = lattice.rows(box);
  const std::size_t nBatches = (rows.size() + rowsPerBatch - 1) / rowsPerBatch;
  std::vector<std::vector<Vec<Dim>>> kept(nBatches);
  parallelFor(nBatches, [&](std::size_t batch) {
    const std::size_t first = batch * rowsPerBatch;
    const std::size_t count = std::min(rowsPerBatch, rows.size() - first);
    kept[batch] = march<Dim>(std::span(rows).subspan(first, count), geometry, band);
  });
  std::vector<Vec<Dim>> points;
  for (const auto& batch : kept) points.insert(points.end(), batch.begin(), batch.end());
  wrapInto(box, points);
  return points;
}

template <int Dim>
std::vector<double> signedDistances(const Geometry<Dim>& geometry,
                                    std::span<const Vec<Dim>> points) {
  std::vector<double> result(points.size());
  inBatches(points.size(), [&](std::size_t first, std::size_t count) {
    geometry.signedDistance(points.subspan(first, count), std::span(result).subspan(first, count));
  });
  return result;
}

template <int Dim>
std::vector<SurfacePoint<Dim>> closestPoints(const Geometry<Dim>& geometry,
                                             std::span<const Vec<Dim>> points) {
  std::vector<SurfacePoint<Dim>> result(points.size());
  inBatches(points.size(), [&](std::size_t first, std::size_t count) {
    geometry.closest(points.subspan(first, count), std::span(result).subspan(first, count));
  });
  return result;
}

template std::vector<Vec<1>> latticePoints(const Lattice<1>&, const Box<1>&);
template std::vector<Vec<1>> latticePoints(const Lattice<1>&, const Box<1>&, const Geometry<1>&,
                                           DistanceBand);
template std::vector<double> signedDistances(const Geometry<1>&, std::span<const Vec<1>>);
template std::vector<SurfacePoint<1>> closestPoints(const Geometry<1>&, std::span<const Vec<1>>);
template std::vector<Vec<2>> latticePoints(const Lattice<2>&, const Box<2>&);
template std::vector<Vec<2>> latticePoints(const Lattice<2>&, const Box<2>&, const Geometry<2>&,
                                           DistanceBand);
template std::vector<double> signedDistances(const Geometry<2>&, std::span<const Vec<2>>);
template std::vector<SurfacePoint<2>> closestPoints(const Geometry<2>&, std::span<const Vec<2>>);
template std::vector<Vec<3>> latticePoints(const Lattice<3>&, const Box<3>&);
template std::vector<Vec<3>> latticePoints(const Lattice<3>&, const Box<3>&, const Geometry<3>&,
                                           DistanceBand);
template std::vector<double> signedDistances(const Geometry<3>&, std::span<const Vec<3>>);
template std::vector<SurfacePoint<3>> closestPoints(const Geometry<3>&, std::span<const Vec<3>>);

}  // namespace plenum
