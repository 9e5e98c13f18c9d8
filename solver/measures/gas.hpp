// SPDX-License-Identifier: GPL-3.0-or-later
//
// What measures of gases share.
#pragma once

#include "solver/measures/observed.hpp"

#include <limits>
#include <numbers>
#include <string>

namespace plenum {

/// Throws InputError that names `key` unless the run's gas is isothermal or ideal.
void requireGas(const SolverSettings& settings, const std::string& key);

/// The same unless it is ideal.
void requireIdealGas(const SolverSettings& settings, const std::string& key);

/// Smoothing length of a particle [m].
template <int Dim>
double smoothingLengthOf(const Observed<Dim>& state, std::size_t i) {
  return state.particles.has(FieldId::smoothingLength) ? state.particles[field::smoothingLength][i]
                                                       : state.smoothingLength;
}

/// Mean of a quantity over the volumes of particles: sum of V a / sum of V.
struct VolumeMean {
  double sum = 0, volume = 0;

  VolumeMean& operator+=(const VolumeMean& b) {
    sum += b.sum;
    volume += b.volume;
    return *this;
  }
  /// NaN where there are no particles.
  double value() const {
    return volume > 0 ? sum / volume : std::numeric_limits<double>::quiet_NaN();
  }
};

/// A vector as case files give it; empty means zero.
template <int Dim>
Vec<Dim> vectorOf(const std::vector<double>& components) {
  Vec<Dim> x{};
  for (std::size_t a = 0; a < components.size() && a < Dim; ++a)
    x[static_cast<int>(a)] = components[a];
  return x;
}

/// Surface of the unit ball: 2, 2 pi, 4 pi in 1, 2, 3 dimensions.
constexpr double unitSphereSurface(int dim) {
  return dim == 1 ? 2 : 2 * (dim - 1) * std::numbers::pi;
}

}  // namespace plenum
