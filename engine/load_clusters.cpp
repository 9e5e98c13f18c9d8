// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once for each instruction set and precision.
#include "engine/load_clusters.hpp"

#include "engine/instruction_set.hpp"

namespace plenum {

namespace {

constexpr std::size_t n = clusterSize;

/// Eight particles' numbers by component.
template <class Isa, std::size_t components, class T>
[[gnu::always_inline]] inline void transpose(const double* values, double scale, T* row) {
  for (std::size_t a = 0; a < components; ++a)
    for (std::size_t k = 0; k < n; ++k)
      row[a * n + k] = static_cast<T>(scale * values[k * components + a]);
}

/// As in Periodicity.
template <class Isa>
[[gnu::always_inline]] inline double nearestImage(double x, double period, double half) {
  x -= x > half ? period : 0;
  return x + (x < -half ? period : 0);
}

}  // namespace

template <class Isa, class T, int Dim>
void loadPositions(const PositionSource<Dim>& source, const ClusterRun& run, T* to) {
  for (std::size_t c = 0; c < run.nClusters; ++c, to += Dim * n) {
    const std::size_t left = run.nParticles - c * n, count = left < n ? left : n;
    const Vec<Dim>* from = source.positions + run.firstParticle + c * n;
    const double* origin = &source.origins[run.firstCluster + c].components[0];
    double x[n * Dim];
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t a = 0; a < Dim; ++a) x[k * Dim + a] = from[k].components[a] - origin[a];
    if (source.anyPeriodic)
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t a = 0; a < Dim; ++a)
          x[k * Dim + a] = nearestImage<Isa>(x[k * Dim + a], source.period.components[a],
                                             source.half.components[a]);
    for (std::size_t k = count; k < n; ++k)
      for (std::size_t a = 0; a < Dim; ++a) x[k * Dim + a] = source.away * static_cast<double>(k);
    transpose<Isa, Dim>(x, source.scale, to);
  }
}

template <class Isa, class T, int components>
void loadField(const double* values, double scale, const ClusterRun& run, std::size_t stride,
               T* to) {
  constexpr std::size_t nC = components;
  const std::size_t nWhole = run.nParticles / n;
  for (std::size_t c = 0; c < nWhole; ++c)
    transpose<Isa, nC>(values + c * n * nC, scale, to + c * stride);
  if (nWhole == run.nClusters) return;
  double last[n * nC];
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = nWhole * n + k < run.nParticles ? nWhole * n + k : run.nParticles - 1;
    for (std::size_t a = 0; a < nC; ++a) last[k * nC + a] = values[i * nC + a];
  }
  transpose<Isa, nC>(last, scale, to + nWhole * stride);
}

using Isa = isa::PLENUM_ISA;
using T = PLENUM_REAL;
template void loadPositions<Isa, T, 1>(const PositionSource<1>&, const ClusterRun&, T*);
template void loadPositions<Isa, T, 2>(const PositionSource<2>&, const ClusterRun&, T*);
template void loadPositions<Isa, T, 3>(const PositionSource<3>&, const ClusterRun&, T*);
template void loadField<Isa, T, 1>(const double*, double, const ClusterRun&, std::size_t, T*);
template void loadField<Isa, T, 2>(const double*, double, const ClusterRun&, std::size_t, T*);
template void loadField<Isa, T, 3>(const double*, double, const ClusterRun&, std::size_t, T*);

}  // namespace plenum
