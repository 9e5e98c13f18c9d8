// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/common_region.hpp"

#include "geometry/half_spaces.hpp"
#include "geometry/nearest_common.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plenum {

namespace {

/// The size against which round-off is judged: the largest coordinate of any finite bound.
template <int Dim>
double sizeOf(const std::vector<Part<Dim>>& parts, const Box<Dim>& searchBox) {
  double size = 0;
  const auto include = [&](const Box<Dim>& box) {
    for (int a = 0; a < Dim; ++a)
      for (const double x : {box.lower[a], box.upper[a]})
        if (std::isfinite(x)) size = std::max(size, std::abs(x));
  };
  include(searchBox);
  for (const Part<Dim>& part : parts) include(part.geometry->bounds());
  return size > 0 ? size : 1;
}

/// The 3^Dim - 1 directions to the neighbours of a cell of a grid.
template <int Dim>
std::vector<Vec<Dim>> compassDirections() {
  std::vector<Vec<Dim>> directions;
  int count = 1;
  for (int a = 0; a < Dim; ++a) count *= 3;
  for (int code = 0; code < count; ++code) {
    Vec<Dim> d;
    for (int a = 0, rest = code; a < Dim; ++a, rest /= 3) d[a] = rest % 3 - 1;
    if (norm(d) > 0) directions.push_back(d / norm(d));
  }
  return directions;
}

}  // namespace

template <int Dim>
CommonRegion<Dim>::CommonRegion(std::vector<Part<Dim>> parts, const Box<Dim>& searchBox)
    : parts_(std::move(parts)), resolution_(1e-10 * sizeOf(parts_, searchBox)) {
  interior_ = findInterior(searchBox);
}

template <int Dim>
double CommonRegion<Dim>::value(const Vec<Dim>& x) const {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Part<Dim>& part : parts_)
    largest = std::max(largest, part.sign * part.geometry->signedDistance(x));
  return largest;
}

template <int Dim>
SurfacePoint<Dim> CommonRegion<Dim>::bindingPart(const Vec<Dim>& x) const {
  SurfacePoint<Dim> hit = parts_.front().closest(x);
  for (std::size_t k = 1; k < parts_.size(); ++k) {
    const SurfacePoint<Dim> other = parts_[k].closest(x);
    if (other.signedDistance > hit.signedDistance) hit = other;
  }
  return hit;
}

template <int Dim>
SurfacePoint<Dim> CommonRegion<Dim>::closest(const Vec<Dim>& x) const {
  const SurfacePoint<Dim> hit = bindingPart(x);
  // Inside, the nearest surface of any part is C's. Outside, its distance is a lower bound: if the
  // point belongs to C nothing is nearer.
  if (hit.signedDistance < -resolution_) return hit;
  if (value(hit.point) <= resolution_ && touchesInterior(hit.point)) return hit;

  const Vec<Dim> nearest = nearestCommonPoint(*this, x, *interior_);
  const double distance = norm(x - nearest);
  if (distance <= resolution_) return {nearest, hit.normal, distance};
  return {nearest, (x - nearest) / distance, distance};
}

template <int Dim>
bool CommonRegion<Dim>::touchesInterior(const Vec<Dim>& p) const {
  const double depth = 100 * resolution_;
  Constraints<Dim> inwards;  // on a step from p: down by one along the normal of every part there
  const auto add = [&](const SurfacePoint<Dim>& hit, double least) {
    if (hit.signedDistance < least || inwards.n == inwards.most) return;
    inwards.value[std::size_t(inwards.n)] = 1;
    inwards.normal[std::size_t(inwards.n++)] = hit.normal;
  };
  for (const Part<Dim>& part : parts_) add(part.closest(p), -4 * resolution_);
  if (inwards.n <= 1) return true;

  // A part with an edge at p has more normals than one: those that a failed step meets are added.
  for (int before = 0; before < inwards.n;) {
    const Projection<Dim> steepest = project(inwards, 1e-9);
    if (steepest.violation > 1e-3 || norm(steepest.shift) > 1e4) break;
    const Vec<Dim> inside = p + 2 * depth * steepest.shift;
    if (value(inside) < -depth) return true;
    before = inwards.n;
    for (const Part<Dim>& part : parts_) add(part.closest(inside), -depth);
  }
  // Notches have no such direction: try all around.
  static const std::vector<Vec<Dim>> directions = compassDirections<Dim>();
  return std::any_of(directions.begin(), directions.end(),
                     [&](const Vec<Dim>& d) { return value(p + 100 * depth * d) < -depth; });
}

template <int Dim>
std::optional<Vec<Dim>> CommonRegion<Dim>::findInterior(const Box<Dim>& searchBox) const {
  struct Cell {
    Vec<Dim> center;
    Vec<Dim> half;
    double value;
  };
  const auto deeper = [](const Cell& a, const Cell& b) {
    return a.value - norm(a.half) < b.value - norm(b.half);
  };
  const auto deepestLast = [&](const Cell& a, const Cell& b) { return deeper(b, a); };
  constexpr std::size_t budget = 20000;

  for (int a = 0; a < Dim; ++a)
    if (!(searchBox.lower[a] < searchBox.upper[a])) return std::nullopt;
  std::vector<Cell> heap{{searchBox.center(), 0.5 * searchBox.extent(), value(searchBox.center())}};
  std::optional<Cell> best;
  std::size_t n = 0;
  while (!heap.empty() && ++n < budget) {
    std::pop_heap(heap.begin(), heap.end(), deepestLast);
    const Cell cell = heap.back();
    heap.pop_back();
    if (cell.value < -1e4 * resolution_ && (!best || cell.value < best->value)) best = cell;
    const double bound = cell.value - norm(cell.half);
    if (bound > (best ? 2 * best->value : -1e4 * resolution_)) break;  // half the depth will do
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      Vec<Dim> center = cell.center;
      for (int a = 0; a < Dim; ++a) center[a] += ((corner >> a) & 1 ? 0.5 : -0.5) * cell.half[a];
      heap.push_back({center, 0.5 * cell.half, value(center)});
      std::push_heap(heap.begin(), heap.end(), deepestLast);
    }
  }
  if (!best) return std::nullopt;
  return best->center;
}

template class CommonRegion<1>;
template class CommonRegion<2>;
template class CommonRegion<3>;

}  // namespace plenum
