// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/fill.hpp"

#include "geometry/analytic.hpp"
#include "geometry/march.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace plenum {

namespace {

constexpr std::size_t rowsPerBatch = 64;
constexpr std::size_t pointsPerBatch = 4096;

/// In edges: where a band ends further from the surface, rows are marched.
constexpr double mostFromSurface = 1e-3;

/// A point a rounding error below a periodic face stands on it.
template <int Dim>
Vec<Dim> wrapped(const Box<Dim>& box, Vec<Dim> x) {
  for (int a = 0; a < Dim; ++a)
    if (box.isPeriodic(a) && x[a] < box.lower[a]) x[a] = box.lower[a];
  return x;
}

/// Neighbouring points of a row that are kept.
struct Kept {
  std::size_t row;
  std::int64_t begin;
  std::int64_t end;
};

/// Twice as far as need be, and far above round-off, so that surely is surely.
double surely(double near, double edge) { return 2 * near + 1e-8 * edge; }

/// What is kept of some rows.
struct Batch {
  std::vector<Kept> runs;
  std::size_t nPoints = 0;

  void keep(std::size_t row, std::int64_t begin, std::int64_t end) {
    if (!runs.empty() && runs.back().row == row && runs.back().end == begin)
      runs.back().end = end;
    else
      runs.push_back({row, begin, end});
    nPoints += static_cast<std::size_t>(end - begin);
  }
};

/// Decides about rows `first` to `last` of `rows`.
template <int Dim>
using Chooser = std::function<Batch(std::span<const LatticeRow<Dim>> rows, std::size_t first,
                                    std::size_t last)>;

/// Chooses in all threads, counts, and makes the points in one piece.
template <int Dim>
std::vector<Vec<Dim>> chosenPoints(std::span<const LatticeRow<Dim>> rows, const Box<Dim>& box,
                                   const Chooser<Dim>& choose) {
  std::vector<Batch> batches((rows.size() + rowsPerBatch - 1) / rowsPerBatch);
  parallelFor(batches.size(), [&](std::size_t b) {
    const std::size_t first = b * rowsPerBatch;
    batches[b] = choose(rows, first, std::min(first + rowsPerBatch, rows.size()));
  });
  std::vector<std::size_t> start(batches.size() + 1, 0);
  for (std::size_t b = 0; b < batches.size(); ++b) start[b + 1] = start[b] + batches[b].nPoints;
  std::vector<Vec<Dim>> points(start.back());
  parallelFor(batches.size(), [&](std::size_t b) {
    std::size_t k = start[b];
    for (const Kept& run : batches[b].runs)
      for (std::int64_t i = run.begin; i < run.end; ++i)
        points[k++] = wrapped(box, rows[run.row].point(i));
  });
  return points;
}

/// Marches by signed distance; only points are kept whose distance lies in `band`.
template <int Dim>
Batch marchBand(std::span<const LatticeRow<Dim>> rows, std::size_t first, std::size_t last,
                const Geometry<Dim>& geometry, DistanceBand band) {
  std::vector<std::int64_t> counts;
  for (std::size_t r = first; r < last; ++r) counts.push_back(rows[r].count);
  RowRuns runs;
  march(
      geometry, counts, rows[first].edge,
      [&](std::size_t r, std::int64_t i) { return rows[first + r].point(i); },
      [&](double distance) -> Verdict {
        const double inward = std::min(distance - band.lower, band.upper - distance);
        return {inward >= 0 ? PointPlace::inside : PointPlace::outside, std::abs(inward)};
      },
      runs);
  Batch batch;
  for (std::size_t r = first; r < last; ++r) {
    std::int64_t begin = 0;
    for (const RowRun& run : runs[r - first]) {
      if (run.place == PointPlace::inside) batch.keep(r, begin, run.end);
      begin = run.end;
    }
  }
  return batch;
}

/// Keeps what lies surely inside if the band has no lower end, and of the unknown points those in
/// the band.
template <int Dim>
Batch chooseByRuns(std::span<const LatticeRow<Dim>> rows, std::size_t first, std::size_t last,
                   const Geometry<Dim>& geometry, const RowClassifier<Dim>& classifier,
                   DistanceBand band) {
  std::vector<Row<Dim>> asked;
  for (std::size_t r = first; r < last; ++r) asked.push_back({rows[r].point(0), rows[r].count});
  RowRuns runs;
  classifier.classify(asked, runs);
  const auto forEachRun = [&](auto&& visit) {
    for (std::size_t r = first; r < last; ++r) {
      std::int64_t begin = 0;
      for (const RowRun& run : runs[r - first]) {
        visit(r, begin, run);
        begin = run.end;
      }
    }
  };
  std::vector<Vec<Dim>> unknown;
  forEachRun([&](std::size_t r, std::int64_t begin, const RowRun& run) {
    if (run.place == PointPlace::unknown)
      for (std::int64_t i = begin; i < run.end; ++i) unknown.push_back(rows[r].point(i));
  });
  std::vector<double> distances(unknown.size());
  if (!unknown.empty()) geometry.signedDistance(unknown, distances);
  Batch batch;
  std::size_t k = 0;
  forEachRun([&](std::size_t r, std::int64_t begin, const RowRun& run) {
    if (run.place == PointPlace::inside && std::isinf(band.lower)) batch.keep(r, begin, run.end);
    if (run.place == PointPlace::unknown)
      for (std::int64_t i = begin; i < run.end; ++i, ++k)
        if (distances[k] >= band.lower && distances[k] <= band.upper) batch.keep(r, i, i + 1);
  });
  return batch;
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
  const std::vector<LatticeRow<Dim>> rows = lattice.rows(box);
  return chosenPoints<Dim>(rows, box, [](auto all, std::size_t first, std::size_t last) {
    Batch batch;
    for (std::size_t r = first; r < last; ++r) batch.keep(r, 0, all[r].count);
    return batch;
  });
}

template <int Dim>
std::vector<Vec<Dim>> latticePoints(const Lattice<Dim>& lattice, const Box<Dim>& box,
                                    const Geometry<Dim>& geometry, DistanceBand band) {
  const std::vector<LatticeRow<Dim>> rows = lattice.rows(box);
  if (rows.empty()) return {};
  const double edge = rows.front().edge;
  const double most = mostFromSurface * edge;
  const bool endsAtSurface =
      std::abs(band.upper) <= most && (band.lower >= -most || std::isinf(band.lower));
  if (!endsAtSurface)
    return chosenPoints<Dim>(rows, box, [&](auto all, std::size_t first, std::size_t last) {
      return marchBand(all, first, last, geometry, band);
    });
  const double lower = std::isinf(band.lower) ? 0 : std::abs(band.lower);
  const double near = surely(std::max(lower, std::abs(band.upper)), edge);
  const auto classifier = geometry.rowClassifier(edge * unitVector<Dim>(0), near);
  return chosenPoints<Dim>(rows, box, [&](auto all, std::size_t first, std::size_t last) {
    return chooseByRuns(all, first, last, geometry, *classifier, band);
  });
}

template <int Dim>
std::vector<PointPlace> placesOf(const Geometry<Dim>& geometry, std::span<const Vec<Dim>> points,
                                 double edge, double near) {
  const Vec<Dim> step = edge * unitVector<Dim>(0);
  const auto classifier = geometry.rowClassifier(step, surely(near, edge));
  std::vector<PointPlace> places(points.size(), PointPlace::unknown);
  inBatches(points.size(), [&](std::size_t first, std::size_t count) {
    std::vector<Row<Dim>> rows;
    for (const Vec<Dim>& x : points.subspan(first, count)) {
      const auto isNext = [&](const Row<Dim>& row) {
        const Vec<Dim> off = x - row.first - static_cast<double>(row.count) * step;
        return normSquared(off) <= 1e-18 * edge * edge;
      };
      if (rows.empty() || !isNext(rows.back())) rows.push_back({x, 0});
      ++rows.back().count;
    }
    RowRuns runs;
    classifier->classify(rows, runs);
    std::size_t k = first;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::size_t start = k;
      for (const RowRun& run : runs[r])
        while (k < start + static_cast<std::size_t>(run.end)) places[k++] = run.place;
    }
  });
  return places;
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
template std::vector<PointPlace> placesOf(const Geometry<1>&, std::span<const Vec<1>>, double,
                                          double);
template std::vector<double> signedDistances(const Geometry<1>&, std::span<const Vec<1>>);
template std::vector<SurfacePoint<1>> closestPoints(const Geometry<1>&, std::span<const Vec<1>>);
template std::vector<Vec<2>> latticePoints(const Lattice<2>&, const Box<2>&);
template std::vector<Vec<2>> latticePoints(const Lattice<2>&, const Box<2>&, const Geometry<2>&,
                                           DistanceBand);
template std::vector<PointPlace> placesOf(const Geometry<2>&, std::span<const Vec<2>>, double,
                                          double);
template std::vector<double> signedDistances(const Geometry<2>&, std::span<const Vec<2>>);
template std::vector<SurfacePoint<2>> closestPoints(const Geometry<2>&, std::span<const Vec<2>>);
template std::vector<Vec<3>> latticePoints(const Lattice<3>&, const Box<3>&);
template std::vector<Vec<3>> latticePoints(const Lattice<3>&, const Box<3>&, const Geometry<3>&,
                                           DistanceBand);
template std::vector<PointPlace> placesOf(const Geometry<3>&, std::span<const Vec<3>>, double,
                                          double);
template std::vector<double> signedDistances(const Geometry<3>&, std::span<const Vec<3>>);
template std::vector<SurfacePoint<3>> closestPoints(const Geometry<3>&, std::span<const Vec<3>>);

}  // namespace plenum
