// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/voids.hpp"

#include "engine/container_move.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace plenum {

namespace {

/// Points in the middles of the cells of a grid over a box. A band is a number of layers of them
/// across the last axis.
template <int Dim>
struct SampleGrid {
  static constexpr int last = Dim - 1;

  std::array<std::ptrdiff_t, Dim> shape;
  Vec<Dim> lower, edge;
  std::ptrdiff_t layerSize = 1;

  SampleGrid(const Box<Dim>& box, double wanted) : lower(box.lower) {
    for (int a = 0; a < Dim; ++a) {
      const double length = box.upper[a] - box.lower[a];
      const auto n =
          std::max<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(std::ceil(length / wanted)));
      shape[static_cast<std::size_t>(a)] = n;
      edge[a] = length / static_cast<double>(n);
      if (a != last) layerSize *= n;
    }
  }

  double coordinate(int axis, std::ptrdiff_t k) const {
    return lower[axis] + edge[axis] * (static_cast<double>(k) + 0.5);
  }

  /// Points whose coordinate is within `reach` of x, [first, end).
  std::array<std::ptrdiff_t, 2> near(int axis, double x, double reach) const {
    const auto n = static_cast<double>(shape[static_cast<std::size_t>(axis)]);
    const auto clamped = [n](double s) {
      return static_cast<std::ptrdiff_t>(s > 0 ? (s < n ? s : n) : 0.0);
    };
    const double s = (x - lower[axis]) / edge[axis] - 0.5, r = reach / edge[axis];
    return {clamped(std::ceil(s - r)), clamped(std::floor(s + r) + 1)};
  }
};

/// What the points of a band have around them.
template <int Dim>
class Band {
 public:
  static constexpr std::uint8_t allOrthants = (1u << (1u << Dim)) - 1;  // one bit an orthant

  Band(const SampleGrid<Dim>& grid, std::ptrdiff_t first, std::ptrdiff_t end, double spacing,
       double reach)
      : grid_(grid), first_(first), end_(end), spacing_(spacing), reach_(reach) {
    const auto size = static_cast<std::size_t>((end - first) * grid.layerSize);
    orthants_.resize(size);
    isNear_.resize(size);
  }

  /// Marks the points that are near a particle at x.
  void mark(const Vec<Dim>& x) {
    markFrom(std::integral_constant<int, Dim - 1>{}, x, 0, reach_ * reach_, 0);
  }

  /// visit(point, whether a particle is near, whether there are some in all orthants).
  template <class Visit>
  void forEachPoint(Visit&& visit) const {
    for (std::size_t k = 0; k < isNear_.size(); ++k) {
      Vec<Dim> x;
      auto rest = static_cast<std::ptrdiff_t>(k) + first_ * grid_.layerSize;
      for (int a = 0; a < Dim; ++a) {
        const std::ptrdiff_t n = grid_.shape[static_cast<std::size_t>(a)];
        x[a] = grid_.coordinate(a, a == Dim - 1 ? rest : rest % n);
        rest /= n;
      }
      visit(x, isNear_[k] != 0, orthants_[k] == allOrthants);
    }
  }

 private:
  std::array<std::ptrdiff_t, 2> rangeOf(int axis, double x, double reach) const {
    auto range = grid_.near(axis, x, reach);
    if (axis == Dim - 1) range = {std::max(range[0], first_), std::min(range[1], end_)};
    return range;
  }

  /// `offset` is that of the points in the layers before; left: of reach^2; orthant: its bits of
  /// the axes before.
  template <int axis>
  void markFrom(std::integral_constant<int, axis>, const Vec<Dim>& x, std::ptrdiff_t offset,
                double left, unsigned orthant) {
    const auto [first, end] = rangeOf(axis, x[axis], std::sqrt(left));
    const std::ptrdiff_t start = axis == Dim - 1 ? first_ : 0;
    const std::ptrdiff_t row = offset * grid_.shape[static_cast<std::size_t>(axis)] - start;
    if constexpr (axis == 0) {
      markRow(x[0], row, first, end, left, orthant);
    } else {
      for (std::ptrdiff_t k = first; k < end; ++k) {
        const double d = x[axis] - grid_.coordinate(axis, k);
        const double rest = left - d * d;
        const unsigned bits = orthant | ((d > 0 ? 1u : 0u) << axis);
        if (rest > 0) markFrom(std::integral_constant<int, axis - 1>{}, x, row + k, rest, bits);
      }
    }
  }

  /// Whole stretches of a row at once: bytes that the processor takes by the dozen.
  void markRow(double x, std::ptrdiff_t row, std::ptrdiff_t first, std::ptrdiff_t end, double left,
               unsigned orthant) {
    std::ptrdiff_t middle = first;  // the particle is above the points before it
    while (middle < end && grid_.coordinate(0, middle) < x) ++middle;
    const auto mark = [&](std::ptrdiff_t from, std::ptrdiff_t to, unsigned bits) {
      const auto mask = static_cast<std::uint8_t>(1u << bits);
      for (std::ptrdiff_t k = from; k < to; ++k)
        orthants_[static_cast<std::size_t>(row + k)] |= mask;
    };
    mark(first, middle, orthant | 1u);
    mark(middle, end, orthant);
    const double near = left - (reach_ * reach_ - spacing_ * spacing_);
    if (near < 0) return;
    const auto [nearFirst, nearEnd] = rangeOf(0, x, std::sqrt(near));
    for (std::ptrdiff_t k = nearFirst; k < nearEnd; ++k)
      isNear_[static_cast<std::size_t>(row + k)] = 1;
  }

  const SampleGrid<Dim>& grid_;
  std::ptrdiff_t first_, end_;
  double spacing_, reach_;
  std::vector<std::uint8_t> orthants_, isNear_;
};

/// Where particles are in the container as it stood at first, with their periodic images within
/// `reach` of a box.
template <int Dim>
std::vector<Vec<Dim>> placesAround(const Box<Dim>& box, const ParticleSet<Dim>& particles,
                                   const SceneInfo<Dim>& info, double reach) {
  const auto toStart = containerMove(info, info.time, info.startTime);
  const Vec<Dim> length = info.domain.extent();
  Box<Dim> around = box;
  around.lower -= Vec<Dim>::filled(reach);
  around.upper += Vec<Dim>::filled(reach);
  std::vector<Vec<Dim>> places, images;
  for (const Vec<Dim>& x : particles[field::position]) {
    images = {info.domain.wrap(toStart(x))};
    for (int a = 0; a < Dim; ++a) {
      if (!info.domain.isPeriodic(a)) continue;
      for (std::size_t k = images.size(); k-- > 0;)
        for (const double shift : {-length[a], length[a]}) {
          Vec<Dim> image = images[k];
          image[a] += shift;
          images.push_back(image);
        }
    }
    for (const Vec<Dim>& image : images)
      if (around.contains(image)) places.push_back(image);
  }
  return places;
}

}  // namespace

template <int Dim>
double measureVoids(const ParticleSet<Dim>& particles, const SceneInfo<Dim>& info,
                    bool freeSurface) {
  const double spacing = info.spacing, reach = (freeSurface ? 2 : 1) * spacing;
  const Box<Dim> box = info.container.empty() ? info.domain : info.container.bounds();
  const SampleGrid<Dim> grid(box, spacing / 3);
  const std::vector<Vec<Dim>> places = placesAround(box, particles, info, reach);

  // Bands as high as the reach is wide, so that a particle is near two of them.
  constexpr int last = Dim - 1;
  const std::ptrdiff_t nLayers = grid.shape[last];
  const auto height = static_cast<std::ptrdiff_t>(std::ceil(2 * reach / grid.edge[last]));
  const std::ptrdiff_t nBands = (nLayers + height - 1) / height;
  std::vector<std::vector<std::uint32_t>> placesOf(static_cast<std::size_t>(nBands));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto [first, end] = grid.near(last, places[k][last], reach);
    for (std::ptrdiff_t b = first / height; b * height < end; ++b)
      placesOf[static_cast<std::size_t>(b)].push_back(static_cast<std::uint32_t>(k));
  }

  std::size_t points = 0, holes = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : points, holes)
  for (std::ptrdiff_t b = 0; b < nBands; ++b) {
    Band<Dim> band(grid, b * height, std::min(nLayers, (b + 1) * height), spacing, reach);
    for (const std::uint32_t k : placesOf[static_cast<std::size_t>(b)]) band.mark(places[k]);
    band.forEachPoint([&](const Vec<Dim>& x, bool isNear, bool isSurrounded) {
      if (freeSurface && !isSurrounded) return;
      if (info.container.signedDistance(x) >= 0) return;
      ++points;
      if (!isNear) ++holes;
    });
  }
  return points > 0 ? static_cast<double>(holes) / static_cast<double>(points) : 0;
}

template double measureVoids<1>(const ParticleSet<1>&, const SceneInfo<1>&, bool);
template double measureVoids<2>(const ParticleSet<2>&, const SceneInfo<2>&, bool);
template double measureVoids<3>(const ParticleSet<3>&, const SceneInfo<3>&, bool);

}  // namespace plenum
