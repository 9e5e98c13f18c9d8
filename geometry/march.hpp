// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"

#include <cmath>
#include <span>
#include <vector>

namespace plenum {

/// What the signed distance of a point says about it, and within which distance of the point the
/// same holds [m].
struct Verdict {
  PointPlace place = PointPlace::unknown;
  double reach = 0;
};

/// How many points from here on a verdict covers, this one included.
inline std::int64_t coveredSteps(double reach, double step, std::int64_t left) {
  if (!(reach < step * static_cast<double>(left))) return left;  // also without any surface
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(reach / step * (1 - 1e-9)) + 1);
}

/// Marches along rows of counts[r] points, `step` [m] apart: pointOf(r, i) is point i of row r, and
/// judge(signed distance) its Verdict. Signed distances change by at most the distance moved, so
/// the number of queries grows with the surface and not with the volume. Rows are marched together:
/// each round asks the geometry for one batch of points.
template <int Dim, class PointOf, class Judge>
void march(const Geometry<Dim>& geometry, std::span<const std::int64_t> counts, double step,
           PointOf&& pointOf, Judge&& judge, RowRuns& runs) {
  std::vector<std::int64_t> at(counts.size(), 0);
  std::vector<std::vector<RowRun>> found(counts.size());
  std::vector<std::size_t> active;
  for (std::size_t r = 0; r < counts.size(); ++r)
    if (counts[r] > 0) active.push_back(r);
  std::vector<Vec<Dim>> points;
  std::vector<double> distances;
  while (!active.empty()) {
    points.clear();
    for (std::size_t r : active) points.push_back(pointOf(r, at[r]));
    distances.resize(points.size());
    geometry.signedDistance(points, distances);
    for (std::size_t k = 0; k < active.size(); ++k) {
      const std::size_t r = active[k];
      const Verdict verdict = judge(distances[k]);
      at[r] += coveredSteps(verdict.reach, step, counts[r] - at[r]);
      found[r].push_back({at[r], verdict.place});
    }
    std::erase_if(active, [&](std::size_t r) { return at[r] >= counts[r]; });
  }
  runs.clear();
  for (const std::vector<RowRun>& row : found) {
    for (const RowRun& run : row) runs.add(run.end, run.place);
    runs.endRow();
  }
}

}  // namespace plenum
