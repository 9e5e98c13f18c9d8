// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/measures.hpp"

#include "engine/ordered_sum.hpp"
#include "engine/point_search.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace plenum {

namespace {

constexpr double nearestRange = 2.5;  // d_ref; where the search for a neighbour ends

/// Neighbours of psi_6 and q_6.
template <int Dim>
constexpr std::size_t nShell = Dim == 3 ? 12 : 6;

/// The nearest neighbours of a particle, by distance; no allocation.
template <int Dim>
struct Shell {
  static constexpr std::size_t size = nShell<Dim>;
  std::array<double, size> distanceSquared;
  std::array<Vec<Dim>, size> offset;
  std::size_t count = 0;

  void insert(double d2, const Vec<Dim>& d) {
    if (count == size && d2 >= distanceSquared[size - 1]) return;
    std::size_t k = count < size ? count++ : size - 1;
    for (; k > 0 && distanceSquared[k - 1] > d2; --k) {
      distanceSquared[k] = distanceSquared[k - 1];
      offset[k] = offset[k - 1];
    }
    distanceSquared[k] = d2;
    offset[k] = d;
  }
};

struct SpacingSums {
  double nearest = 0, below01 = 0, below05 = 0, below085 = 0, psi6 = 0, nPsi6 = 0;
  double minNearest = std::numeric_limits<double>::infinity();

  SpacingSums& operator+=(const SpacingSums& b) {
    nearest += b.nearest;
    below01 += b.below01;
    below05 += b.below05;
    below085 += b.below085;
    psi6 += b.psi6;
    nPsi6 += b.nPsi6;
    minNearest = std::min(minNearest, b.minNearest);
    return *this;
  }
};

double psi6Of(const Shell<2>& shell) {
  double re = 0, im = 0;
  for (const Vec<2>& d : shell.offset) {
    const double angle = 6 * std::atan2(d[1], d[0]);
    re += std::cos(angle);
    im += std::sin(angle);
  }
  return std::hypot(re, im) / Shell<2>::size;
}

/// sqrt(4 pi/13 sum over m of |mean of Y_6m|^2), by the addition theorem of the harmonics.
double q6Of(const Shell<3>& shell) {
  double sum = 0;
  for (std::size_t a = 0; a < Shell<3>::size; ++a)
    for (std::size_t b = 0; b < Shell<3>::size; ++b) {
      const double c = dot(shell.offset[a], shell.offset[b]) /
                       std::sqrt(shell.distanceSquared[a] * shell.distanceSquared[b]);
      const double c2 = c * c;
      sum += (((231 * c2 - 315) * c2 + 105) * c2 - 5) / 16;  // Legendre's P_6
    }
  return std::sqrt(std::max(sum, 0.0)) / Shell<3>::size;
}

template <int Dim>
SpacingSums sumsOf(const Shell<Dim>& shell, double spacing) {
  SpacingSums s;
  s.nearest = shell.count > 0 ? std::sqrt(shell.distanceSquared[0]) / spacing : nearestRange;
  s.minNearest = s.nearest;
  s.below01 = s.nearest < 0.1;
  s.below05 = s.nearest < 0.5;
  s.below085 = s.nearest < 0.85;
  if constexpr (Dim == 2)
    if (shell.count == Shell<2>::size) {
      s.psi6 = psi6Of(shell);
      s.nPsi6 = 1;
    }
  return s;
}

/// The grid of sampling points over a box, at about `wanted` [m].
template <int Dim>
struct SampleGrid {
  std::array<std::size_t, Dim> shape;
  Vec<Dim> lower, edge;
  std::size_t size = 1;

  SampleGrid(const Box<Dim>& box, double wanted) : lower(box.lower) {
    for (int a = 0; a < Dim; ++a) {
      const double length = box.upper[a] - box.lower[a];
      const auto n = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length / wanted)));
      shape[static_cast<std::size_t>(a)] = n;
      edge[a] = length / static_cast<double>(n);
      size *= n;
    }
  }

  Vec<Dim> point(std::size_t index) const {
    Vec<Dim> x;
    for (int a = 0; a < Dim; ++a) {
      const std::size_t n = shape[static_cast<std::size_t>(a)];
      x[a] = lower[a] + edge[a] * (static_cast<double>(index % n) + 0.5);
      index /= n;
    }
    return x;
  }
};

struct VoidSums {
  double points = 0, holes = 0;
  VoidSums& operator+=(const VoidSums& b) {
    points += b.points;
    holes += b.holes;
    return *this;
  }
};

}  // namespace

template <int Dim>
SpacingMeasures measureSpacing(const ParticleSet<Dim>& particles, const Box<Dim>& domain,
                               double spacing) {
  const auto fluid = particles[field::position].first(particles.nFluid());
  const PointSearch<Dim> search(fluid, domain, nearestRange * spacing);
  const auto sums = orderedSum<SpacingSums>(fluid.size(), [&](std::size_t i) {
    Shell<Dim> shell;
    search.around(fluid[i], [&](std::uint32_t j, const Vec<Dim>& d, double d2) {
      if (j != i) shell.insert(d2, d);
    });
    return sumsOf(shell, spacing);
  });
  const auto n = static_cast<double>(fluid.size());
  SpacingMeasures m;
  m.minNearest = sums.minNearest;
  m.meanNearest = sums.nearest / n;
  m.below01 = sums.below01 / n;
  m.below05 = sums.below05 / n;
  m.below085 = sums.below085 / n;
  m.psi6 = sums.nPsi6 > 0 ? sums.psi6 / sums.nPsi6 : 0;
  return m;
}

namespace {

template <int Dim>
Neighbourhood neighbourhoodOf(const Shell<Dim>& shell, double nearestSquared) {
  Neighbourhood result{std::min(nearestRange, std::sqrt(nearestSquared)),
                       std::numeric_limits<double>::quiet_NaN()};
  if (shell.count < Shell<Dim>::size || shell.distanceSquared[0] == 0) return result;
  if constexpr (Dim == 2) result.bondOrder = psi6Of(shell);
  if constexpr (Dim == 3) result.bondOrder = q6Of(shell);
  return result;
}

}  // namespace

template <int Dim>
std::vector<Neighbourhood> neighbourhoods(const ParticleSet<Dim>& particles, const Box<Dim>& domain,
                                          std::span<const double> spacing) {
  const auto all = particles[field::position];
  const std::size_t n = particles.nFluid();
  std::vector<Neighbourhood> result(n);
  if (n == 0) return result;
  // Spacings may differ by far: each octave of them has a search of its own, so that nobody looks
  // through the crowd of much denser places.
  const auto [least, most] =
      std::minmax_element(spacing.begin(), spacing.begin() + static_cast<std::ptrdiff_t>(n));
  for (double upper = 2 * *least, lower = 0; lower <= *most; lower = upper, upper *= 2) {
    std::vector<std::size_t> who;
    for (std::size_t i = 0; i < n; ++i)
      if (spacing[i] >= lower && spacing[i] < upper) who.push_back(i);
    if (who.empty()) continue;
    const PointSearch<Dim> search(all, domain, nearestRange * std::min(upper, *most));
    forEachIndex(who.size(), [&](std::size_t k) {
      const std::size_t i = who[k];
      Shell<Dim> shell;
      double nearestSquared = std::numeric_limits<double>::infinity();
      search.around(all[i], [&](std::uint32_t j, const Vec<Dim>& d, double d2) {
        if (j == i) return;
        shell.insert(d2, d);
        const double between = 0.5 * (spacing[i] + spacing[j]);
        nearestSquared = std::min(nearestSquared, d2 / (between * between));
      });
      result[i] = neighbourhoodOf(shell, nearestSquared);
    });
  }
  return result;
}

namespace {

/// The motion of the container, if it has one: that of the walls, if all move as one.
template <int Dim>
const RigidMotion* containerMotion(const SceneInfo<Dim>& info) {
  if (info.walls.empty() || info.walls.front().motion.isStill()) return nullptr;
  const RigidMotion& first = info.walls.front().motion;
  const bool isCommon =
      std::ranges::all_of(info.walls, [&](const Wall& wall) { return wall.motion == first; });
  return isCommon ? &first : nullptr;
}

/// Where a point of the container at `before` [s] is at `after`.
template <int Dim>
auto containerMove(const SceneInfo<Dim>& info, double before, double after) {
  std::optional<Displacement> displacement;
  if (const RigidMotion* motion = containerMotion(info))
    displacement.emplace(*motion, before, after);
  return [displacement](const Vec<Dim>& x) { return displacement ? displacement->moved(x) : x; };
}

}  // namespace

template <int Dim>
double measureVoids(const ParticleSet<Dim>& particles, const SceneInfo<Dim>& info,
                    bool freeSurface) {
  constexpr unsigned allOrthants = (1u << (1u << Dim)) - 1;  // one bit an orthant
  const double spacing = info.spacing;
  const PointSearch<Dim> search(particles[field::position], info.domain,
                                (freeSurface ? 2 : 1) * spacing);
  const SampleGrid<Dim> grid(info.container.empty() ? info.domain : info.container.bounds(),
                             spacing / 3);
  const auto toNow = containerMove(info, info.startTime, info.time);
  const auto sums = orderedSum<VoidSums>(grid.size, [&](std::size_t k) {
    const Vec<Dim> x = grid.point(k);
    VoidSums s;
    if (info.container.signedDistance(x) >= 0) return s;
    double nearest = std::numeric_limits<double>::infinity();
    unsigned orthants = 0;
    search.around(toNow(x), [&](std::uint32_t, const Vec<Dim>& d, double d2) {
      nearest = std::min(nearest, d2);
      unsigned orthant = 0;
      for (int a = 0; a < Dim; ++a) orthant |= (d[a] > 0 ? 1u : 0u) << a;
      orthants |= 1u << orthant;
    });
    if (freeSurface && orthants != allOrthants) return s;
    s.points = 1;
    s.holes = nearest > spacing * spacing;
    return s;
  });
  return sums.points > 0 ? sums.holes / sums.points : 0;
}

template <int Dim>
std::size_t countLeft(const ParticleSet<Dim>& particles, const SceneInfo<Dim>& info) {
  if (info.container.empty()) return 0;
  const auto fluid = particles[field::position].first(particles.nFluid());
  const auto toStart = containerMove(info, info.time, info.startTime);
  return orderedSum<std::size_t>(fluid.size(), [&](std::size_t i) -> std::size_t {
    const Vec<Dim> x = info.domain.wrap(toStart(fluid[i]));
    return info.container.signedDistance(x) > 0.5 * info.spacing;
  });
}

template <int Dim>
std::size_t countEscaped(const ParticleSet<Dim>& particles, const SceneInfo<Dim>& info) {
  const auto fluid = particles[field::position].first(particles.nFluid());
  const auto toStart = containerMove(info, info.time, info.startTime);
  return orderedSum<std::size_t>(fluid.size(), [&](std::size_t i) -> std::size_t {
    return !info.domain.contains(info.domain.wrap(toStart(fluid[i])));
  });
}

template SpacingMeasures measureSpacing<1>(const ParticleSet<1>&, const Box<1>&, double);
template SpacingMeasures measureSpacing<2>(const ParticleSet<2>&, const Box<2>&, double);
template SpacingMeasures measureSpacing<3>(const ParticleSet<3>&, const Box<3>&, double);
template std::vector<Neighbourhood> neighbourhoods(const ParticleSet<1>&, const Box<1>&,
                                                   std::span<const double>);
template double measureVoids<1>(const ParticleSet<1>&, const SceneInfo<1>&, bool);
template std::vector<Neighbourhood> neighbourhoods(const ParticleSet<2>&, const Box<2>&,
                                                   std::span<const double>);
template double measureVoids<2>(const ParticleSet<2>&, const SceneInfo<2>&, bool);
template std::vector<Neighbourhood> neighbourhoods(const ParticleSet<3>&, const Box<3>&,
                                                   std::span<const double>);
template double measureVoids<3>(const ParticleSet<3>&, const SceneInfo<3>&, bool);
template std::size_t countLeft<1>(const ParticleSet<1>&, const SceneInfo<1>&);
template std::size_t countLeft<2>(const ParticleSet<2>&, const SceneInfo<2>&);
template std::size_t countLeft<3>(const ParticleSet<3>&, const SceneInfo<3>&);
template std::size_t countEscaped<1>(const ParticleSet<1>&, const SceneInfo<1>&);
template std::size_t countEscaped<2>(const ParticleSet<2>&, const SceneInfo<2>&);
template std::size_t countEscaped<3>(const ParticleSet<3>&, const SceneInfo<3>&);

}  // namespace plenum
