// SPDX-License-Identifier: GPL-3.0-or-later
//
// A row is followed through the triangles that it passes. Where it comes within `near` of one,
// nothing is said; between such stretches it is inside or outside, which the triangles that it
// crossed tell by the side that they turn to it.
//
// Seen along the rows the surface is a plane figure, with corners rounded once. Crossings are
// decided in that figure by exact orientations and, on edges and corners, by one rule, as if the
// row were moved aside by nothing: so each crossing of the surface counts once, however the row
// hits it. Rounding the corners moves the surface by far less than `near`, which changes no side of
// a point that is further from it than that.
#include "geometry/triangle_rows.hpp"

#include "geometry/orientation.hpp"
#include "geometry/triangle_buckets.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace plenum {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Right-handed axes: two across the rows and one along them. A coordinate axis stays exact.
struct Frame {
  Vec<3> across[2];
  Vec<3> along;

  explicit Frame(const Vec<3>& step) : along(step / norm(step)) {
    int least = 0;
    for (int a = 1; a < 3; ++a)
      if (std::abs(along[a]) < std::abs(along[least])) least = a;
    Vec<3> axis;
    axis[least] = 1;
    across[0] = cross(along, axis);
    across[0] = across[0] / norm(across[0]);
    across[1] = cross(along, across[0]);
  }

  Vec<2> flat(const Vec<3>& x) const { return {{dot(across[0], x), dot(across[1], x)}}; }
};

/// 2-D cross product, and the sum of the sizes of its parts, which bounds its rounding.
struct Area {
  double value;
  double size;
};
Area areaOf(const Vec<2>& u, const Vec<2>& v) {
  const double left = u[0] * v[1];
  const double right = u[1] * v[0];
  return {left - right, std::abs(left) + std::abs(right)};
}

/// What a row meets in a triangle: nothing is known from `begin` to `end` [m along the row], and
/// `exits` crossings outwards (-1: one inwards) lie there.
struct Meeting {
  double begin;
  double end;
  int exits;
};

class TriangleRows final : public RowClassifier<3> {
 public:
  TriangleRows(const TriangleSoup& soup, const Vec<3>& step, double near)
      : soup_(soup), frame_(step), stepLength_(norm(step)) {
    double size = 0;
    for (const Vec<3>& x : soup.points) size = std::max(size, norm(x));
    near_ = near + 16 * epsilon * size;
    flat_.reserve(soup.points.size());
    along_.reserve(soup.points.size());
    for (const Vec<3>& x : soup.points) {
      flat_.push_back(frame_.flat(x));
      along_.push_back(dot(frame_.along, x));
    }
    std::vector<Box<2>> boxes;
    boxes.reserve(soup.triangles.size());
    for (const auto& [a, b, c] : soup.triangles)
      boxes.push_back(
          Box<2>::nothing().extend(flat_[a]).extend(flat_[b]).extend(flat_[c]).grown(near_));
    buckets_.emplace(boxes);
  }

  void classify(std::span<const Row<3>> rows, RowRuns& runs) const override {
    runs.clear();
    std::vector<Meeting> meetings;
    for (const Row<3>& row : rows) {
      meetings.clear();
      const Vec<2> at = frame_.flat(row.first);
      for (const std::uint32_t t : buckets_->at(at)) meet(t, at, meetings);
      std::ranges::sort(meetings, {}, &Meeting::begin);
      if (isConsistent(meetings))
        addRuns(row, meetings, runs);
      else
        runs.add(row.count, PointPlace::unknown);
      runs.endRow();
    }
  }

 private:
  void meet(std::size_t t, const Vec<2>& at, std::vector<Meeting>& meetings) const;
  bool passesNear(const Vec<2> corners[3], const Area& area) const;
  int exitsAt(const std::array<std::size_t, 3>& corners, const Vec<2>& at) const;
  static bool isConsistent(std::span<const Meeting> meetings);
  void addRuns(const Row<3>& row, std::span<const Meeting> meetings, RowRuns& runs) const;

  const TriangleSoup& soup_;
  Frame frame_;
  double stepLength_;
  double near_;
  std::vector<Vec<2>> flat_;   ///< corners across the rows [m]
  std::vector<double> along_;  ///< and along them
  std::optional<TriangleBuckets> buckets_;
};

/// False only if the line at zero is further than near_ from the triangle: each side has the
/// triangle within its height on one side. Slivers have no inner side, so both ends count.
bool TriangleRows::passesNear(const Vec<2> corners[3], const Area& area) const {
  for (int k = 0; k < 3; ++k) {
    const Vec<2>& from = corners[k];
    const Vec<2>& to = corners[(k + 1) % 3];
    const Area side = areaOf(from, to);
    const double margin = near_ * norm(to - from) + 4 * epsilon * (side.size + area.size);
    if (side.value < std::fmin(0, area.value) - margin ||
        side.value > std::fmax(0, area.value) + margin)
      return false;
  }
  return true;
}

void TriangleRows::meet(std::size_t t, const Vec<2>& at, std::vector<Meeting>& meetings) const {
  const auto& [a, b, c] = soup_.triangles[t];
  const Vec<2> corners[3] = {flat_[a] - at, flat_[b] - at, flat_[c] - at};
  for (int axis = 0; axis < 2; ++axis)
    if (std::fmin(std::fmin(corners[0][axis], corners[1][axis]), corners[2][axis]) > near_ ||
        std::fmax(std::fmax(corners[0][axis], corners[1][axis]), corners[2][axis]) < -near_)
      return;
  const Vec<2> u = corners[1] - corners[0];
  const Vec<2> v = corners[2] - corners[0];
  const Area area = areaOf(u, v);
  if (!passesNear(corners, area)) return;

  // The row's way through the slab of thickness 2 near_ around the triangle's plane, and between
  // the triangle's ends.
  const double low = std::fmin(std::fmin(along_[a], along_[b]), along_[c]) - near_;
  const double high = std::fmax(std::fmax(along_[a], along_[b]), along_[c]) + near_;
  const double du = along_[b] - along_[a];
  const double dv = along_[c] - along_[a];
  const Vec<3> normal{{u[1] * dv - du * v[1], du * v[0] - u[0] * dv, area.value}};
  const double edges = (norm(u) + std::abs(du)) * (norm(v) + std::abs(dv));
  const double rounding = 8 * epsilon * edges;  // of each component of `normal`
  Meeting meeting{low, high, exitsAt(soup_.triangles[t], at)};
  if (std::abs(area.value) > 4 * rounding) {
    const double middle =
        along_[a] + (normal[0] * corners[0][0] + normal[1] * corners[0][1]) / area.value;
    const double reach = norm(corners[0]) + high - low;  // from the row to the first corner
    const double half = (near_ * norm(normal) + 4 * rounding * reach) / std::abs(area.value);
    const double begin = std::fmax(low, middle - half);
    const double end = std::fmin(high, middle + half);
    if (begin <= end) {
      meeting.begin = begin;
      meeting.end = end;
    } else if (meeting.exits == 0) {
      return;
    }
  }
  meetings.push_back(meeting);
}

/// How often the outline winds around the row: +1 if the row leaves the region there.
int TriangleRows::exitsAt(const std::array<std::size_t, 3>& corners, const Vec<2>& at) const {
  int winding = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec<2>& from = flat_[corners[k]];
    const Vec<2>& to = flat_[corners[(k + 1) % 3]];
    const bool upwards = from[1] <= at[1] && to[1] > at[1];
    const bool downwards = from[1] > at[1] && to[1] <= at[1];
    if (upwards && orientation(from, to, at) > 0) ++winding;
    if (downwards && orientation(from, to, at) < 0) --winding;
  }
  return winding;
}

/// Stretches in which triangles are met leave the row inside once or outside, and at last outside.
/// It cannot be otherwise for a closed surface that does not cross itself; were it so, the exact
/// question would decide.
bool TriangleRows::isConsistent(std::span<const Meeting> meetings) {
  int depth = 0;
  double end = -std::numeric_limits<double>::infinity();
  for (const Meeting& meeting : meetings) {
    if (meeting.begin > end && depth != 0 && depth != 1) return false;
    depth -= meeting.exits;
    end = std::fmax(end, meeting.end);
  }
  return depth == 0;
}

void TriangleRows::addRuns(const Row<3>& row, std::span<const Meeting> meetings,
                           RowRuns& runs) const {
  const double start = dot(frame_.along, row.first);
  const auto n = static_cast<double>(row.count);
  const auto inSteps = [&](double along) {
    return std::fmin(std::fmax((along - start) / stepLength_, -1), n);
  };
  int depth = 0;
  for (std::size_t k = 0; k < meetings.size();) {
    const double begin = meetings[k].begin;
    double end = begin;
    const PointPlace before = depth > 0 ? PointPlace::inside : PointPlace::outside;
    for (; k < meetings.size() && (meetings[k].begin <= end); ++k) {
      end = std::fmax(end, meetings[k].end);
      depth -= meetings[k].exits;
    }
    runs.add(static_cast<std::int64_t>(std::ceil(inSteps(begin))), before);
    runs.add(std::min(row.count, static_cast<std::int64_t>(std::floor(inSteps(end))) + 1),
             PointPlace::unknown);
  }
  runs.add(row.count, PointPlace::outside);
}

}  // namespace

std::unique_ptr<const RowClassifier<3>> classifierOfTriangles(const TriangleSoup& soup,
                                                              const Vec<3>& step, double near) {
  return std::make_unique<const TriangleRows>(soup, step, near);
}

}  // namespace plenum
