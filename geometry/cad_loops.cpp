// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cad_file.hpp"
#include "geometry/gmsh_session.hpp"
#include "geometry/print.hpp"
#include "geometry/text_reader.hpp"
#include "particles/box.hpp"
#include "particles/errors.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace plenum {

namespace {

using Polyline = std::vector<Vec<3>>;

double distanceToSegment(const Vec<3>& x, const Vec<3>& a, const Vec<3>& b) {
  const double length2 = normSquared(b - a);
  const double share = length2 > 0 ? std::clamp(dot(x - a, b - a) / length2, 0., 1.) : 0;
  return norm(x - a - share * (b - a));
}

/// Cuts a curve into chords.
class CurveCutter {
 public:
  CurveCutter(int tag, double tolerance) : tag_(tag), tolerance_(tolerance) {}

  Polyline cut() {
    std::vector<double> begin, end;
    gmsh::model::getParametrizationBounds(1, tag_, begin, end);
    std::string type;
    gmsh::model::getType(1, tag_, type);
    const std::vector<Vec<3>> ends = at({begin[0], end[0]});
    line_ = {ends[0]};
    if (type == "Line")
      line_.push_back(ends[1]);
    else
      refine(begin[0], ends[0], end[0], ends[1], 0);
    return line_;
  }

  double deviation() const { return deviation_; }

 private:
  std::vector<Vec<3>> at(const std::vector<double>& parameters) const {
    std::vector<double> x;
    gmsh::model::getValue(1, tag_, parameters, x);
    std::vector<Vec<3>> points;
    for (std::size_t k = 0; k + 2 < x.size(); k += 3)
      points.push_back({{x[k], x[k + 1], x[k + 2]}});
    return points;
  }

  /// Appends the chords from a (already there) to b. Looks at three points between them, so that a
  /// turning point in the middle does not pass for a straight line.
  void refine(double ta, const Vec<3>& a, double tb, const Vec<3>& b, int depth) {
    constexpr int firstDepth = 2;
    constexpr int lastDepth = 20;
    const double middle = 0.5 * (ta + tb);
    const std::vector<Vec<3>> between = at({0.5 * (ta + middle), middle, 0.5 * (middle + tb)});
    double deviation = 0;
    for (const Vec<3>& x : between) deviation = std::max(deviation, distanceToSegment(x, a, b));
    if (depth < firstDepth || (deviation > tolerance_ && depth < lastDepth)) {
      refine(ta, a, middle, between[1], depth + 1);
      refine(middle, between[1], tb, b, depth + 1);
      return;
    }
    deviation_ = std::max(deviation_, deviation);
    line_.push_back(b);
  }

  int tag_;
  double tolerance_;
  double deviation_ = 0;
  Polyline line_;
};

/// Edges of the mesh that belong to one face only.
std::vector<Polyline> meshBoundary(const std::string& source) {
  std::vector<std::size_t> tags;
  std::vector<double> x, unused;
  gmsh::model::mesh::getNodes(tags, x, unused);
  std::map<std::size_t, Vec<3>> nodes;
  for (std::size_t k = 0; k < tags.size(); ++k)
    nodes[tags[k]] = {{x[3 * k], x[3 * k + 1], x[3 * k + 2]}};

  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements, corners;
  gmsh::model::mesh::getElements(types, elements, corners, 2);
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  for (std::size_t k = 0; k < types.size(); ++k) {
    std::string name;
    int dimension, order, nNodes, nCorners;
    gmsh::model::mesh::getElementProperties(types[k], name, dimension, order, nNodes, unused,
                                            nCorners);
    for (std::size_t e = 0; e < elements[k].size(); ++e) {
      const auto corner = [&](int c) {
        return corners[k][e * std::size_t(nNodes) + std::size_t(c)];
      };
      for (int c = 0; c < nCorners; ++c)
        ++uses[std::minmax({corner(c), corner((c + 1) % nCorners)})];
    }
  }
  if (uses.empty())
    throw InputError(source + ": has no triangles; save the 2-D mesh of the surface with it");
  std::vector<Polyline> lines;
  for (const auto& [edge, n] : uses)
    if (n == 1) lines.push_back({nodes.at(edge.first), nodes.at(edge.second)});
  return lines;
}

/// The lines joined end to end.
std::vector<Loop> joined(const std::vector<Polyline>& lines, double near,
                         const std::string& source) {
  std::vector<Vec<3>> ends;
  for (const Polyline& line : lines) {
    ends.push_back(line.front());
    ends.push_back(line.back());
  }
  const std::vector<std::size_t> corner = mergedPoints(ends, near);
  std::vector<std::vector<std::size_t>> endsAt(ends.size());
  for (std::size_t e = 0; e < ends.size(); ++e) endsAt[corner[e]].push_back(e);
  for (std::size_t e = 0; e < ends.size(); ++e)
    if (!endsAt[e].empty() && endsAt[e].size() != 2)
      throw InputError(
          fmt::format("{}: {} boundary lines meet at {}; every corner must join two: "
                      "close gaps, part regions that touch",
                      source, endsAt[e].size(), printed(ends[e])));
  std::vector<Loop> loops;
  std::vector<bool> done(lines.size(), false);
  for (std::size_t first = 0; first < lines.size(); ++first) {
    if (done[first]) continue;
    loops.emplace_back();
    for (std::size_t end = 2 * first; !done[end / 2];) {  // `end` is where the line is entered
      done[end / 2] = true;
      Polyline line = lines[end / 2];
      if (end % 2 == 1) std::ranges::reverse(line);
      for (std::size_t k = 0; k + 1 < line.size(); ++k)
        loops.back().push_back({{line[k][0], line[k][1]}});
      const std::size_t other = end ^ 1;
      const auto& pair = endsAt[corner[other]];
      end = pair[0] == other ? pair[1] : pair[0];
    }
  }
  return loops;
}

void checkFlat(const std::vector<Polyline>& lines, double tolerance, const std::string& source) {
  Box<3> box = Box<3>::nothing();
  for (const Polyline& line : lines)
    for (const Vec<3>& x : line) box.extend(x);
  if (box.upper[2] - box.lower[2] > tolerance)
    throw InputError(
        fmt::format("{}: is not flat in the x-y plane (z from {:.6g} to {:.6g} m); "
                    "rotate it there in the CAD tool, or set dimension = 3",
                    source, box.lower[2], box.upper[2]));
}

}  // namespace

CadLoops readCadLoops(const std::filesystem::path& path, std::optional<double> tolerance,
                      double relativeTolerance) {
  const std::string source = path.string();
  GmshSession session;
  session.open(path);
  CadLoops result;
  session.guarded(source, [&] {
    gmsh::vectorpair volumes, surfaces, curves;
    gmsh::model::getEntities(volumes, 3);
    gmsh::model::getEntities(surfaces, 2);
    if (!volumes.empty())
      throw InputError(source +
                       ": is 3-D (it has volumes), the case has dimension = 2; give its "
                       "flat cross-section, or set dimension = 3");
    if (surfaces.empty())
      throw InputError(source +
                       ": has no surface, only curves or points; add the plane surface "
                       "that they bound");
    Vec<3> lower, upper;
    gmsh::model::getBoundingBox(-1, -1, lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
    const double size = norm(upper - lower);
    result.tolerance = tolerance.value_or(relativeTolerance * size);
    std::vector<Polyline> lines;
    if (extensionOf(path) == ".msh") {
      lines = meshBoundary(source);
    } else {
      gmsh::model::getBoundary(surfaces, curves, true, false, false);
      for (const auto& [dimension, tag] : curves) {
        CurveCutter cutter(std::abs(tag), result.tolerance);
        lines.push_back(cutter.cut());
        result.deviation = std::max(result.deviation, cutter.deviation());
      }
    }
    checkFlat(lines, std::max(result.tolerance, 1e-6 * size), source);
    result.loops = joined(lines, 1e-6 * size, source);
  });
  return result;
}

}  // namespace plenum
