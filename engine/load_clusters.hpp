// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the state of particles to the numbers that pairs are computed from. Plain pointers only, as
// in tile_work.hpp.
#pragma once

#include "engine/spatial_order.hpp"
#include "particles/vec.hpp"

#include <cstdint>

namespace plenum {

/// Consecutive clusters.
struct ClusterRun {
  std::size_t begin, end;
  const std::uint32_t* first;  ///< particle of every cluster, and the end of the last one
};

/// Positions of a run relative to the origins of the clusters [cluster][axis][particle], times
/// `scale`.
template <int Dim>
struct PositionSource {
  const Vec<Dim>* positions;  ///< of all particles [m]
  const Vec<Dim>* origins;    ///< of all clusters [m]
  Vec<Dim> period, half;      ///< as in Periodicity
  bool anyPeriodic;
  double away;   ///< places without a particle lie that far away [m]
  double scale;  ///< to the unit of length of the pairs [1/m]
};
template <class Isa, class T, int Dim>
void loadPositions(const PositionSource<Dim>& source, const ClusterRun& run, T* to);

/// A field of a run times `scale`: [particle][component] to [cluster][component][particle], where a
/// cluster's numbers begin every `stride`. Places without a particle get the values of the last
/// one. `values` are those of all particles, `to` begins with the run's first cluster.
template <class Isa, class T, int components>
void loadField(const double* values, double scale, const ClusterRun& run, std::size_t stride,
               T* to);

/// Of all particles: (numerator + addend) / (density secondDensity); null: 1, 0 and 1.
struct DerivedSource {
  const double *numerator, *addend, *density, *secondDensity;
};

/// The same for a field that is computed.
template <class Isa, class T>
void loadDerived(const DerivedSource& source, double scale, const ClusterRun& run,
                 std::size_t stride, T* to);

}  // namespace plenum
