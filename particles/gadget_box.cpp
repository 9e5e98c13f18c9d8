// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/gadget_box.hpp"

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
std::vector<double> gadgetCoordinates(const Scene<Dim>& scene, const GadgetBox& box,
                                      bool& changed) {
  const auto positions = scene.particles[field::position];
  std::vector<double> rows(3 * positions.size(), 0.0);
  bool anyChanged = false;
  const auto n = static_cast<std::ptrdiff_t>(positions.size());
#pragma omp parallel for schedule(static) reduction(|| : anyChanged)
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    for (int a = 0; a < Dim; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      const double y = folded(positions[i][a], box.shift[axis], box.size[axis]);
      rows[3 * i + axis] = y;
      anyChanged =
          anyChanged || y != positions[i][a] || std::signbit(y) != std::signbit(positions[i][a]);
    }
  }
  changed = anyChanged;
  return rows;
}

template GadgetBox gadgetBox(const Scene<1>&);
template GadgetBox gadgetBox(const Scene<2>&);
template GadgetBox gadgetBox(const Scene<3>&);
template std::vector<double> gadgetCoordinates(const Scene<1>&, const GadgetBox&, bool&);
template std::vector<double> gadgetCoordinates(const Scene<2>&, const GadgetBox&, bool&);
template std::vector<double> gadgetCoordinates(const Scene<3>&, const GadgetBox&, bool&);

}  // namespace plenum
