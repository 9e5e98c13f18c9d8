// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/picture_projection.hpp"

#include "particles/errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plenum {

namespace {

constexpr Colour edgeGrey{190, 190, 190};

/// The view of 3-D pictures: parallel projection from azimuth -60 degrees, elevation 25 degrees.
struct Eye {
  Vec<3> toViewer, right, up;
  Eye() {
    const double azimuth = -60 * std::numbers::pi / 180, elevation = 25 * std::numbers::pi / 180;
    const double ca = std::cos(azimuth), sa = std::sin(azimuth);
    const double ce = std::cos(elevation), se = std::sin(elevation);
    toViewer = {{ce * ca, ce * sa, se}};
    right = {{-sa, ca, 0}};
    up = {{-se * ca, -se * sa, ce}};
  }
};

Vec<3> corner(const Box<3>& box, int bits) {
  Vec<3> x;
  for (int a = 0; a < 3; ++a) x[a] = (bits >> a & 1) != 0 ? box.upper[a] : box.lower[a];
  return x;
}

template <int Dim>
bool isFinite(const Vec<Dim>& x) {
  return std::isfinite(norm(x));
}

/// Bounds of all particles, or of the middle `1 - 2 tail` of them and a tenth more if the rest
/// would double the extent.
template <int Dim>
Box<Dim> robustBounds(std::span<const Vec<Dim>> positions, double tail) {
  Box<Dim> box = Box<Dim>::nothing();
  std::vector<double> values;
  for (int a = 0; a < Dim; ++a) {
    values.clear();
    for (const Vec<Dim>& x : positions)
      if (isFinite(x)) values.push_back(x[a]);
    if (values.empty()) return box;
    const auto quantile = [&](double share) {
      const auto at =
          values.begin() +
          static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(values.size() - 1)));
      std::nth_element(values.begin(), at, values.end());
      return *at;
    };
    const double least = quantile(0), most = quantile(1);
    const double low = quantile(tail), high = quantile(1 - tail);
    const bool hasOutliers = most - least > 2 * (high - low);
    const double more = 0.1 * (high - low);
    box.lower[a] = hasOutliers ? std::max(least, low - more) : least;
    box.upper[a] = hasOutliers ? std::min(most, high + more) : most;
  }
  return box;
}

/// A wall between viewer and fluid turns its inside, where the fluid is, away from the viewer.
bool hidesFluid(const Vec<3>& normal, const Eye& eye) { return dot(normal, eye.toViewer) < -0.2; }

}  // namespace

template <int Dim>
Box<Dim> defaultView(const ParticleSet<Dim>& particles, const std::optional<Box<Dim>>& container) {
  const auto positions = particles[field::position];
  Box<Dim> box = Box<Dim>::nothing();
  for (const Vec<Dim>& x : positions.subspan(particles.nFluid()))
    if (isFinite(x)) box.extend(x);
  if (container) return box.extend(*container);
  const bool hasWalls = particles.nWalls() > 0;
  const Box<Dim> fluid =
      robustBounds<Dim>(positions.first(particles.nFluid()), hasWalls ? 0.05 : 0.01);
  if (fluid.isFinite()) box.extend(fluid);
  if (!box.isFinite()) throw InputError("no picture: no particle has a finite position");
  return box;
}

template <int Dim>
double estimatedSpacing(const ParticleSet<Dim>& particles,
                        const std::optional<Box<Dim>>& container) {
  const Vec<Dim> extent = defaultView(particles, container).extent();
  double volume = 1;
  int axes = 0;
  for (int a = 0; a < Dim; ++a) {
    if (!(extent[a] > 0)) continue;
    volume *= extent[a];
    ++axes;
  }
  return axes == 0 ? 1 : std::pow(volume / static_cast<double>(particles.size()), 1.0 / axes);
}

template <int Dim>
std::optional<Box<Dim>> containerBounds(const SceneInfo<Dim>& info) {
  Box<Dim> box = Box<Dim>::nothing();
  const ContainerMap<Dim>& map = info.container;
  for (std::size_t k = 0; k < map.counts.size(); ++k) {
    if (map.counts[k] > 0) continue;
    std::size_t rest = k;
    Vec<Dim> low = map.lower;
    for (int a = 0; a < Dim; ++a) {
      const auto length = static_cast<std::size_t>(map.shape[static_cast<std::size_t>(a)]);
      low[a] += map.spacing * static_cast<double>(rest % length);
      rest /= length;
    }
    box.extend(low).extend(low + Vec<Dim>::filled(map.spacing));
  }
  bool allPeriodic = true;
  for (int a = 0; a < Dim; ++a) {
    allPeriodic = allPeriodic && info.domain.isPeriodic(a);
    if (!info.domain.isPeriodic(a) || map.empty()) continue;
    box.lower[a] = info.domain.lower[a];
    box.upper[a] = info.domain.upper[a];
  }
  if (map.empty() && allPeriodic) box = info.domain;
  if (!box.isFinite()) return std::nullopt;
  return box;
}

template <int Dim>
PlaneDots dotsInPlane(const ParticleSet<Dim>& particles, const Box<Dim>& view,
                      const Box<Dim>& shown, int horizontal, int vertical) {
  PlaneDots result;
  const auto positions = particles[field::position];
  for (std::size_t k = positions.size(); k-- > 0;) {  // walls first, fluids above them
    const Vec<Dim>& x = positions[k];
    if (shown.contains(x) && isFinite(x))
      result.dots.push_back({x[horizontal], x[vertical], 0, static_cast<std::uint32_t>(k)});
    else if (!view.contains(x) || !isFinite(x))
      ++result.nOutside;
  }
  return result;
}

PlaneDots dotsInSpace(const ParticleSet<3>& particles, const Box<3>& view) {
  PlaneDots result;
  const Eye eye;
  const bool hasNormals = particles.has(FieldId::normal);
  const double middle = dot(eye.toViewer, view.center());
  const auto positions = particles[field::position];
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const Vec<3>& x = positions[k];
    if (!view.contains(x) || !isFinite(x)) {
      ++result.nOutside;
      continue;
    }
    const double depth = dot(eye.toViewer, x);
    if (k >= particles.nFluid() && particles.nFluid() > 0) {
      const bool hides = hasNormals
                             ? hidesFluid(particles[field::normal][k - particles.nFluid()], eye)
                             : depth > middle;
      result.leavesWallsOut = result.leavesWallsOut || hides;
      if (hides) continue;
    }
    result.dots.push_back({dot(eye.right, x), dot(eye.up, x), static_cast<float>(depth - middle),
                           static_cast<std::uint32_t>(k)});
  }
  std::sort(result.dots.begin(), result.dots.end(),
            [](const PlaneDots::Dot& a, const PlaneDots::Dot& b) {
              return a.depth != b.depth ? a.depth < b.depth : a.particle < b.particle;
            });
  return result;
}

SpaceAxes::SpaceAxes(const Box<3>& box, int width) : box_(box) {
  const Eye eye;
  Box<2> bounds = Box<2>::nothing();
  for (int bits = 0; bits < 8; ++bits)
    bounds.extend(Vec<2>{{dot(eye.right, corner(box, bits)), dot(eye.up, corner(box, bits))}});
  // Room for numbers and names, in pixels.
  const double pixel = bounds.extent()[0] / std::max(200, width - 300);
  view_ = {bounds.lower[0] - 80 * pixel, bounds.upper[0] + 60 * pixel, bounds.lower[1] - 45 * pixel,
           bounds.upper[1] + 8 * pixel};
}

void SpaceAxes::draw(PictureFrame& frame) const {
  const Eye eye;
  int nearest = 0;
  for (int bits = 1; bits < 8; ++bits)
    if (dot(eye.toViewer, corner(box_, bits)) > dot(eye.toViewer, corner(box_, nearest)))
      nearest = bits;
  for (int bits = 0; bits < 8; ++bits)
    for (int a = 0; a < 3; ++a) {
      const int other = bits | 1 << a;
      if (other == bits || bits == nearest || other == nearest) continue;
      const Vec<3> p = corner(box_, bits), q = corner(box_, other);
      frame.canvas().line(frame.toX(dot(eye.right, p)), frame.toY(dot(eye.up, p)),
                          frame.toX(dot(eye.right, q)), frame.toY(dot(eye.up, q)), edgeGrey);
    }
  // The edges on the rim of the picture: below left, below right, left.
  drawNumbers(frame, 0, box_.lower);
  drawNumbers(frame, 1, {{box_.upper[0], box_.lower[1], box_.lower[2]}});
  drawNumbers(frame, 2, box_.lower);
}

void SpaceAxes::drawNumbers(PictureFrame& frame, int axis, const Vec<3>& start) const {
  const Eye eye;
  const auto place = [&](double at) {
    Vec<3> x = start;
    x[axis] = at;
    return Vec<2>{{frame.toX(dot(eye.right, x)), frame.toY(dot(eye.up, x))}};
  };
  const Vec<2> first = place(box_.lower[axis]), last = place(box_.upper[axis]);
  const Vec<2> along = (last - first) / std::max(norm(last - first), 1e-9);
  Vec<2> outwards{{-along[1], along[0]}};
  const Vec<2> center{
      {frame.toX(dot(eye.right, box_.center())), frame.toY(dot(eye.up, box_.center()))}};
  if (dot(outwards, 0.5 * (first + last) - center) < 0) outwards = -outwards;
  const TextStyle style{.size = 14, .horizontal = 0.5 - 0.5 * outwards[0], .vertical = 0.5};
  const Ticks ticks =
      niceTicks(box_.lower[axis], box_.upper[axis], static_cast<int>(norm(last - first) / 90) + 1);
  for (std::size_t k = 0; k < ticks.at.size(); ++k) {
    const Vec<2> p = place(ticks.at[k]), q = p + 5.0 * outwards, r = p + 13.0 * outwards;
    frame.canvas().line(p[0], p[1], q[0], q[1], {110, 110, 110});
    frame.canvas().text(r[0], r[1], ticks.labels[k], style);
  }
  const std::string name = axisTitle(std::string(1, "xyz"[axis]), "m", ticks.exponent);
  const Vec<2> at = 0.5 * (first + last) + 62.0 * outwards;
  // The name of the upright axis reads upwards: there it needs little room.
  frame.canvas().text(at[0], at[1], name,
                      {.size = 15, .horizontal = 0.5, .vertical = 0.5, .upwards = axis == 2});
}

template Box<1> defaultView(const ParticleSet<1>&, const std::optional<Box<1>>&);
template Box<2> defaultView(const ParticleSet<2>&, const std::optional<Box<2>>&);
template Box<3> defaultView(const ParticleSet<3>&, const std::optional<Box<3>>&);
template double estimatedSpacing(const ParticleSet<1>&, const std::optional<Box<1>>&);
template double estimatedSpacing(const ParticleSet<2>&, const std::optional<Box<2>>&);
template double estimatedSpacing(const ParticleSet<3>&, const std::optional<Box<3>>&);
template std::optional<Box<1>> containerBounds(const SceneInfo<1>&);
template std::optional<Box<2>> containerBounds(const SceneInfo<2>&);
template std::optional<Box<3>> containerBounds(const SceneInfo<3>&);
template PlaneDots dotsInPlane(const ParticleSet<2>&, const Box<2>&, const Box<2>&, int, int);
template PlaneDots dotsInPlane(const ParticleSet<3>&, const Box<3>&, const Box<3>&, int, int);

}  // namespace plenum
