// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which points of a row surely lie inside a region, and which surely outside: found for whole runs
// at once, so that an exact signed distance is asked for near the surface only.
#pragma once

#include "particles/vec.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace plenum {

/// What is known of a point's side. In this order: the union of two regions has the larger one.
enum class PointPlace : std::uint8_t { outside, unknown, inside };

/// Points first + i step for i = 0 ... count - 1; rows that are asked about together share `step`.
template <int Dim>
struct Row {
  Vec<Dim> first;          ///< [m]
  std::int64_t count = 0;  ///< >= 0
};

/// Neighbouring points of a row of which the same is known.
struct RowRun {
  std::int64_t end = 0;  ///< one past the last; the run begins where the one before ends
  PointPlace place = PointPlace::unknown;
};

/// The runs of many rows, row by row.
class RowRuns {
 public:
  void clear() {
    runs_.clear();
    firstRun_.assign(1, 0);
  }

  /// Points of the open row up to `end`; nothing if they have a place already.
  void add(std::int64_t end, PointPlace place) {
    const bool isFirst = runs_.size() == firstRun_.back();
    if (end <= (isFirst ? 0 : runs_.back().end)) return;
    if (!isFirst && runs_.back().place == place)
      runs_.back().end = end;
    else
      runs_.push_back({end, place});
  }
  void endRow() { firstRun_.push_back(runs_.size()); }

  std::size_t nRows() const { return firstRun_.size() - 1; }
  std::span<const RowRun> operator[](std::size_t row) const {
    return std::span(runs_).subspan(firstRun_[row], firstRun_[row + 1] - firstRun_[row]);
  }

 private:
  std::vector<RowRun> runs_;
  std::vector<std::size_t> firstRun_{0};
};

/// Points outside become points inside and the other way round.
constexpr PointPlace opposite(PointPlace place) {
  return place == PointPlace::inside    ? PointPlace::outside
         : place == PointPlace::outside ? PointPlace::inside
                                        : PointPlace::unknown;
}

/// The rows of a and b, which have the same points, with decide(place in a, place in b) for each.
template <class Decide>
RowRuns combined(const RowRuns& a, const RowRuns& b, Decide&& decide) {
  RowRuns result;
  for (std::size_t r = 0; r < a.nRows(); ++r) {
    const std::span<const RowRun> left = a[r];
    const std::span<const RowRun> right = b[r];
    for (std::size_t i = 0, j = 0; i < left.size() && j < right.size();) {
      const std::int64_t end = std::min(left[i].end, right[j].end);
      result.add(end, decide(left[i].place, right[j].place));
      if (left[i].end == end) ++i;
      if (right[j].end == end) ++j;
    }
    result.endRow();
  }
  return result;
}

/// Answers for rows of one direction; made by Geometry::rowClassifier. May be called from several
/// threads.
template <int Dim>
class RowClassifier {
 public:
  virtual ~RowClassifier() = default;

  /// Clears `runs` and gives it all points of each of `rows`.
  virtual void classify(std::span<const Row<Dim>> rows, RowRuns& runs) const = 0;
};

}  // namespace plenum
