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
  for (std::size_t c = run.begin; c < run.end; ++c, to += Dim * n) {
    const std::size_t count = run.first[c + 1] - run.first[c];
    const Vec<Dim>* from = source.positions + run.first[c];
    const double* origin = &source.origins[c].components[0];
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
  for (std::size_t c = run.begin; c < run.end; ++c, to += stride) {
    const double* from = values + run.first[c] * nC;
    const std::size_t count = run.first[c + 1] - run.first[c];
    if (count == n) {
      transpose<Isa, nC>(from, scale, to);
      continue;
    }
    double padded[n * nC];
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t a = 0; a < nC; ++a)
        padded[k * nC + a] = from[(k < count ? k : count - 1) * nC + a];
    transpose<Isa, nC>(padded, scale, to);
  }
}

template <class Isa, class T>
void loadDerived(const DerivedSource& source, double scale, const ClusterRun& run,
                 std::size_t stride, T* to) {
  for (std::size_t c = run.begin; c < run.end; ++c, to += stride) {
    const std::size_t begin = run.first[c], count = run.first[c + 1] - begin;
    double values[n];
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = begin + (k < count ? k : count - 1);
      double numerator = source.numerator != nullptr ? source.numerator[i] : 1;
      if (source.addend != nullptr) numerator += source.addend[i];
      values[k] = numerator * (1 / source.density[i]);
      if (source.secondDensity != nullptr) values[k] *= 1 / source.secondDensity[i];
    }
    transpose<Isa, 1>(values, scale, to);
  }
}

using Isa = isa::PLENUM_ISA;
using T = PLENUM_REAL;
template void loadDerived<Isa, T>(const DerivedSource&, double, const ClusterRun&, std::size_t, T*);
template void loadPositions<Isa, T, 1>(const PositionSource<1>&, const ClusterRun&, T*);
template void loadPositions<Isa, T, 2>(const PositionSource<2>&, const ClusterRun&, T*);
template void loadPositions<Isa, T, 3>(const PositionSource<3>&, const ClusterRun&, T*);
template void loadField<Isa, T, 1>(const double*, double, const ClusterRun&, std::size_t, T*);
template void loadField<Isa, T, 2>(const double*, double, const ClusterRun&, std::size_t, T*);
template void loadField<Isa, T, 3>(const double*, double, const ClusterRun&, std::size_t, T*);

}  // namespace plenum
