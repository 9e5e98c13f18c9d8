// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/measures.hpp"

#include "engine/container_move.hpp"
#include "engine/ordered_sum.hpp"
#include "engine/point_search.hpp"
#include "particles/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
template std::vector<Neighbourhood> neighbourhoods(const ParticleSet<2>&, const Box<2>&,
                                                   std::span<const double>);
template std::vector<Neighbourhood> neighbourhoods(const ParticleSet<3>&, const Box<3>&,
                                                   std::span<const double>);
template std::size_t countLeft<1>(const ParticleSet<1>&, const SceneInfo<1>&);
template std::size_t countLeft<2>(const ParticleSet<2>&, const SceneInfo<2>&);
template std::size_t countLeft<3>(const ParticleSet<3>&, const SceneInfo<3>&);
template std::size_t countEscaped<1>(const ParticleSet<1>&, const SceneInfo<1>&);
template std::size_t countEscaped<2>(const ParticleSet<2>&, const SceneInfo<2>&);
template std::size_t countEscaped<3>(const ParticleSet<3>&, const SceneInfo<3>&);

}  // namespace plenum
