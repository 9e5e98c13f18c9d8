// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/set_volume.hpp"

#include "geometry/box_shape.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace plenum {

namespace {

template <int Dim>
using Value = std::function<double(const Vec<Dim>&)>;

template <int Dim>
struct Cells {
  std::vector<Vec<Dim>> centers;
  Vec<Dim> half;

  double radius() const { return norm(half); }
  double cellVolume() const { return Box<Dim>{-half, half, {}}.volume(); }

  /// The cells of half the size.
  Cells refined() const {
    Cells next{{}, 0.5 * half};
    for (const Vec<Dim>& center : centers)
      for (int corner = 0; corner < (1 << Dim); ++corner) {
        Vec<Dim> x = center;
        for (int a = 0; a < Dim; ++a) x[a] += ((corner >> a) & 1 ? 1 : -1) * next.half[a];
        next.centers.push_back(x);
      }
    return next;
  }
};

template <int Dim>
bool isNothing(const Box<Dim>& box) {
  for (int a = 0; a < Dim; ++a)
    if (box.lower[a] >= box.upper[a]) return true;
  return false;
}

/// True if no point of `box` has value < 0; false if there may be one.
template <int Dim>
bool provenEmpty(const Value<Dim>& value, const Box<Dim>& box) {
  constexpr std::size_t maxCells = 3000;
  if (isNothing(box)) return true;
  const double size = norm(box.extent());
  Cells<Dim> cells{{box.center()}, 0.5 * box.extent()};
  while (!cells.centers.empty() && cells.centers.size() < maxCells) {
    if (cells.radius() < 1e-9 * size) return true;  // they touch in points
    cells = cells.refined();
    bool someInside = false;
    std::erase_if(cells.centers, [&](const Vec<Dim>& x) {
      const double v = value(x);
      someInside = someInside || v < -1e-9 * size;
      return v >= cells.radius();
    });
    if (someInside) return false;
  }
  return cells.centers.empty();
}

/// The share of a box of half extents `half` on the inner side of a plane at `distance` from its
/// centre (negative: the centre is inside).
template <int Dim>
double shareBehindPlane(double distance, const Vec<Dim>& normal, const Vec<Dim>& half) {
  double widest = 0;
  for (int a = 0; a < Dim; ++a) widest = std::max(widest, 2 * std::abs(normal[a]) * half[a]);
  std::vector<double> widths;  // of the box along the normal, by axis
  double depth = -distance;    // of the plane above the lowest corner
  double product = 1;
  for (int a = 0; a < Dim; ++a) {
    const double width = 2 * std::abs(normal[a]) * half[a];
    depth += 0.5 * width;
    if (width < 1e-4 * widest) continue;
    widths.push_back(width);
    product *= width * static_cast<double>(widths.size());
  }
  double sum = 0;  // corner by corner: signed volumes of the simplices below the plane
  for (unsigned corner = 0; corner < (1u << widths.size()); ++corner) {
    double above = depth;
    double sign = 1;
    for (std::size_t a = 0; a < widths.size(); ++a)
      if ((corner >> a) & 1) {
        above -= widths[a];
        sign = -sign;
      }
    if (above > 0) sum += sign * std::pow(above, static_cast<double>(widths.size()));
  }
  return std::clamp(sum / product, 0., 1.);
}

template <int Dim>
const Box<Dim>* asBox(const Geometry<Dim>& geometry) {
  const auto* shape = dynamic_cast<const Analytic<BoxShape<Dim>>*>(&geometry);
  return shape == nullptr ? nullptr : &shape->shape().box;
}

template <int Dim>
bool contains(const Geometry<Dim>& outer, const Geometry<Dim>& inner) {
  const Box<Dim> box = inner.bounds();
  if (!box.isFinite()) return false;
  if (const Box<Dim>* outerBox = asBox(outer))
    return outerBox->contains(box.lower) && outerBox->contains(box.upper);
  if (outer.signedDistance(box.center()) <= -0.5 * norm(box.extent())) return true;
  return provenEmpty<Dim>(
      [&](const Vec<Dim>& x) {
        return std::max(inner.signedDistance(x), -outer.signedDistance(x));
      },
      box);
}

Measure operator+(Measure a, const Measure& b) { return {a.value + b.value, a.error + b.error}; }
Measure operator-(Measure a, const Measure& b) { return {a.value - b.value, a.error + b.error}; }

}  // namespace

template <int Dim>
Relation SetVolume<Dim>::relationOf(const Geometry<Dim>& first, const Geometry<Dim>& second) {
  const Box<Dim> common = commonBox(first.bounds(), second.bounds());
  if (isNothing(common)) return Relation::disjoint;
  if (common.isFinite() && !(asBox(first) != nullptr && asBox(second) != nullptr)) {
    const auto both = [&](const Vec<Dim>& x) {
      return std::max(first.signedDistance(x), second.signedDistance(x));
    };
    if (provenEmpty<Dim>(both, common)) return Relation::disjoint;
  }
  if (contains(second, first)) return Relation::firstInSecond;
  if (contains(first, second)) return Relation::secondInFirst;
  return Relation::unknown;
}

template <int Dim>
std::optional<Measure> SetVolume<Dim>::ofIntersection(Parts parts) {
  while (parts.size() > 1) {
    const GeometryPtr<Dim> last = parts.back();
    parts.pop_back();
    bool merged = false;
    for (GeometryPtr<Dim>& part : parts) {
      const Relation relation = relationOf(*part, *last);
      if (relation == Relation::disjoint) return Measure{0, 0};
      const Box<Dim>* a = asBox(*part);
      const Box<Dim>* b = asBox(*last);
      if (relation == Relation::secondInFirst)
        part = last;
      else if (relation == Relation::unknown && a != nullptr && b != nullptr)
        part = makeGeometry(BoxShape<Dim>{commonBox(*a, *b)});
      else if (relation == Relation::unknown)
        continue;
      merged = true;
      break;
    }
    if (!merged) return std::nullopt;
  }
  return parts.front()->volume();
}

template <int Dim>
std::optional<Measure> SetVolume<Dim>::ofUnion(Parts parts) {
  Measure sum;
  while (!parts.empty()) {  // V(a or rest) = V(rest) + V(a) - V(a and rest)
    const GeometryPtr<Dim> part = parts.back();
    parts.pop_back();
    std::vector<GeometryPtr<Dim>> overlapping;
    bool hidden = false;
    for (const GeometryPtr<Dim>& other : parts) {
      const Relation relation = relationOf(*part, *other);
      hidden = hidden || relation == Relation::firstInSecond;
      if (relation != Relation::disjoint) overlapping.push_back(other);
    }
    if (hidden) continue;
    sum = sum + part->volume();
    std::vector<GeometryPtr<Dim>> common;
    for (const GeometryPtr<Dim>& other : overlapping) {
      const Box<Dim>* a = asBox(*part);
      const Box<Dim>* b = asBox(*other);
      if (relationOf(*part, *other) == Relation::secondInFirst)
        common.push_back(other);
      else if (a != nullptr && b != nullptr)
        common.push_back(makeGeometry(BoxShape<Dim>{commonBox(*a, *b)}));
      else
        return std::nullopt;
    }
    if (common.empty()) continue;
    const std::optional<Measure> twice = ofUnion(common);
    if (!twice) return std::nullopt;
    sum = sum - *twice;
  }
  return sum;
}

template <int Dim>
std::optional<Measure> SetVolume<Dim>::ofDifference(Parts parts) {
  const GeometryPtr<Dim> first = parts.front();
  std::vector<GeometryPtr<Dim>> removed;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const Relation relation = relationOf(*first, *parts[k]);
    if (relation == Relation::disjoint) continue;
    const Box<Dim>* a = asBox(*first);
    const Box<Dim>* b = asBox(*parts[k]);
    if (relation == Relation::secondInFirst)
      removed.push_back(parts[k]);
    else if (a != nullptr && b != nullptr)
      removed.push_back(makeGeometry(BoxShape<Dim>{commonBox(*a, *b)}));
    else
      return std::nullopt;
  }
  const std::optional<Measure> gone = ofUnion(removed);
  if (!gone) return std::nullopt;
  return first->volume() - *gone;
}

template <int Dim>
Measure SetVolume<Dim>::bySubdivision(const Surface& surface, const Box<Dim>& box) {
  constexpr std::size_t maxCells = Dim == 3 ? 120000 : 30000;
  constexpr double safety = 4;  // the error of tangent planes falls at least by two a level
  double full = 0;
  double proven = box.volume();
  double total = 0;
  double change = proven;
  double lastChange = proven;
  Cells<Dim> cells{{box.center()}, 0.5 * box.extent()};
  while (!cells.centers.empty() && cells.centers.size() < maxCells) {
    cells = cells.refined();
    double cut = 0;
    std::erase_if(cells.centers, [&](const Vec<Dim>& x) {
      const SurfacePoint<Dim> hit = surface(x);
      if (hit.signedDistance <= -cells.radius()) full += cells.cellVolume();
      if (std::abs(hit.signedDistance) >= cells.radius()) return true;
      cut += shareBehindPlane(hit.signedDistance, hit.normal, cells.half);
      return false;
    });
    proven = static_cast<double>(cells.centers.size()) * cells.cellVolume();
    lastChange = change;
    change = std::abs(full + cut * cells.cellVolume() - total);
    total = full + cut * cells.cellVolume();
  }
  return {total, std::min(proven, safety * std::max(change, 0.5 * lastChange))};
}

template struct SetVolume<1>;
template struct SetVolume<2>;
template struct SetVolume<3>;

}  // namespace plenum
