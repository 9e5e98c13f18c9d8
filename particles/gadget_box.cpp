// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/gadget_box.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

/// What a reader may take for the kernel's reach; twice the support, so that rounding and a
/// somewhat larger smoothing length do no harm [m].
template <int Dim>
double marginOf(const SceneInfo<Dim>& info) {
  const double length = std::max({4 * info.smoothingLength, 4 * info.spacing, 0.0});
  return length > 0 ? length : 1;
}

/// x + shift folded into [0, size).
double folded(double x, double shift, double size) {
  double y = x + shift;
  if (y >= 0 && y < size) return y;
  y -= size * std::floor(y / size);
  return y >= 0 && y < size ? y : 0;
}

}  // namespace

template <int Dim>
GadgetBox gadgetBox(const Scene<Dim>& scene) {
  Box<Dim> bounds = Box<Dim>::nothing();
  for (const Vec<Dim>& x : scene.particles[field::position]) bounds.extend(x);
  const double margin = marginOf(scene.info);
  GadgetBox box;
  double longest = 0;
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const Box<Dim>& domain = scene.info.domain;
    if (domain.isPeriodic(a)) {
      box.size[axis] = domain.upper[a] - domain.lower[a];
      box.shift[axis] = domain.lower[a] == 0 ? 0 : -domain.lower[a];
    } else if (bounds.lower[a] >= 0) {
      box.size[axis] = bounds.upper[a] + margin;
    } else {
      box.shift[axis] = margin - bounds.lower[a];
      box.size[axis] = bounds.upper[a] + box.shift[axis] + margin;
    }
    longest = std::max(longest, box.size[axis]);
  }
  for (std::size_t axis = Dim; axis < 3; ++axis) box.size[axis] = longest;
  return box;
}

template <int Dim>
void gadgetCoordinates(std::span<const Vec<Dim>> positions, const GadgetBox& box, std::size_t first,
                       std::span<double> rows) {
  forEachIndex(rows.size() / 3, [&](std::size_t i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      rows[3 * i + axis] = axis < Dim ? folded(positions[first + i][static_cast<int>(axis)],
                                               box.shift[axis], box.size[axis])
                                      : 0.0;
  });
}

template <int Dim>
bool changesCoordinates(std::span<const Vec<Dim>> positions, const GadgetBox& box) {
  return std::ranges::any_of(positions, [&](const Vec<Dim>& x) {
    for (int a = 0; a < Dim; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      const double y = folded(x[a], box.shift[axis], box.size[axis]);
      if (y != x[a] || std::signbit(y) != std::signbit(x[a])) return true;
    }
    return false;
  });
}

template GadgetBox gadgetBox(const Scene<1>&);
template GadgetBox gadgetBox(const Scene<2>&);
template GadgetBox gadgetBox(const Scene<3>&);
template void gadgetCoordinates(std::span<const Vec<1>>, const GadgetBox&, std::size_t,
                                std::span<double>);
template bool changesCoordinates(std::span<const Vec<1>>, const GadgetBox&);
template void gadgetCoordinates(std::span<const Vec<2>>, const GadgetBox&, std::size_t,
                                std::span<double>);
template bool changesCoordinates(std::span<const Vec<2>>, const GadgetBox&);
template void gadgetCoordinates(std::span<const Vec<3>>, const GadgetBox&, std::size_t,
                                std::span<double>);
template bool changesCoordinates(std::span<const Vec<3>>, const GadgetBox&);

}  // namespace plenum
