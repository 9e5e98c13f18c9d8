// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/container_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

template <int Dim>
double ContainerMap<Dim>::signedDistance(const Vec<Dim>& x) const {
  if (empty()) return -std::numeric_limits<double>::infinity();
  std::array<int, Dim> cell{};
  std::array<double, Dim> weight{};
  for (int a = 0; a < Dim; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double s = (x[a] - lower[a]) / spacing - 0.5;
    if (!(s > -1 && s < shape[axis])) return 127 * step;
    cell[axis] = std::clamp(static_cast<int>(std::floor(s)), 0, std::max(0, shape[axis] - 2));
    weight[axis] = shape[axis] > 1 ? std::clamp(s - cell[axis], 0.0, 1.0) : 0.0;
  }
  double sum = 0;
  for (int corner = 0; corner < (1 << Dim); ++corner) {
    double product = 1;
    std::size_t at = 0;
    std::size_t stride = 1;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const bool high = (corner >> axis) & 1;
      product *= high ? weight[axis] : 1 - weight[axis];
      const int k = std::min(cell[axis] + (high ? 1 : 0), shape[axis] - 1);
      at += stride * static_cast<std::size_t>(k);
      stride *= static_cast<std::size_t>(shape[axis]);
    }
    if (product > 0) sum += product * counts[at];
  }
  return sum * step;
}

template <int Dim>
Box<Dim> ContainerMap<Dim>::bounds() const {
  Box<Dim> box;
  box.lower = lower;
  for (int a = 0; a < Dim; ++a)
    box.upper[a] = lower[a] + spacing * shape[static_cast<std::size_t>(a)];
  return box;
}

template struct ContainerMap<1>;
template struct ContainerMap<2>;
template struct ContainerMap<3>;

}  // namespace plenum
