// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/print.hpp"
#include "geometry/thicken.hpp"

#include <cmath>

namespace plenum {

namespace {

/// To the right of the way from a to b.
Vec<2> rightOf(const Vec<2>& a, const Vec<2>& b) {
  const Vec<2> along = b - a;
  return Vec<2>{{along[1], -along[0]}} / norm(along);
}

/// Without repeated corners; checked.
Loop cleaned(const Loop& line, const std::string& source) {
  Loop result;
  for (const Vec<2>& corner : line) {
    if (!std::isfinite(corner[0]) || !std::isfinite(corner[1]))
      throw InputError(source +
                       ": a corner of the line is not finite; coordinates must be numbers");
    if (result.empty() || !(result.back() == corner)) result.push_back(corner);
  }
  if (result.size() < 2)
    throw InputError(source + ": a line has only one corner" +
                     (result.empty() ? "" : ", at " + printed(result.front())) +
                     "; a wall needs two or more");
  if (result.back() == result.front())
    throw InputError(fmt::format(
        "{}: a line is closed, it ends where it begins at {}, and thickness is for open lines; for "
        "a region inside it remove thickness and write POLYGON, for a ring take the difference of "
        "two such regions",
        source, printed(result.front())));
  return result;
}

/// How each corner moves for a thickness of 1 to the right.
std::vector<Vec<2>> mitresOf(const Loop& line, const std::string& source) {
  constexpr double sharpest = 0.02;  // 1 + cosine of the turn: a mitre of ten thicknesses
  std::vector<Vec<2>> mitres;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Vec<2> before = rightOf(line[k > 0 ? k - 1 : 0], line[k > 0 ? k : 1]);
    const Vec<2> after = k + 1 < line.size() ? rightOf(line[k], line[k + 1]) : before;
    const double both = 1 + dot(before, after);
    if (both < sharpest)
      throw InputError(
          fmt::format("{}: the line runs back along itself at {}, no thickness fits "
                      "there; give the corner an angle of 12 degrees or more",
                      source, printed(line[k])));
    mitres.push_back((before + after) / both);
  }
  return mitres;
}

/// The line moved by `way` [m] to the right; no edge may turn round.
Loop shifted(const Loop& line, const std::vector<Vec<2>>& mitres, double way, const Thickening& how,
             const std::string& source) {
  Loop result;
  for (std::size_t k = 0; k < line.size(); ++k) result.push_back(line[k] + way * mitres[k]);
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    if (!(dot(result[k + 1] - result[k], line[k + 1] - line[k]) > 0))
      throw InputError(fmt::format(
          "{}: a thickness of {} m is more than the bends of the line leave room for "
          "near {}; {}",
          source, how.thickness, printed(0.5 * (line[k] + line[k + 1])), remedyForThickness(how)));
  return result;
}

}  // namespace

std::vector<PolygonLoops> thickened(const std::vector<Loop>& lines, const Thickening& how,
                                    const std::string& source) {
  const double outwards = how.side == WallSide::outer   ? how.thickness
                          : how.side == WallSide::inner ? 0
                                                        : 0.5 * how.thickness;
  std::vector<PolygonLoops> walls;
  for (const Loop& given : lines) {
    const Loop line = cleaned(given, source);
    const std::vector<Vec<2>> mitres = mitresOf(line, source);
    Loop outline = shifted(line, mitres, outwards, how, source);
    const Loop back = shifted(line, mitres, outwards - how.thickness, how, source);
    outline.insert(outline.end(), back.rbegin(), back.rend());
    walls.push_back({outline, {}});
  }
  return walls;
}

std::string remedyForThickness(const Thickening& how) {
  return how.side == WallSide::outer
             ? "give a smaller thickness, or side = \"inner\" if the other side has room"
             : "give a smaller thickness, or side = \"outer\" if that side has room";
}

}  // namespace plenum
