// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observed.hpp"

namespace plenum {

/// How well the pressure of a column at rest holds: 100 (s/(-rho0 g) - 1) with s the least-squares
/// slope of p over height for the fluid particles in the middle of the column. [C] table 1.
template <int Dim>
class PressureGradient {
 public:
  /// Throws InputError that names `key` for an unknown material, none where the scene has several,
  /// and without gravity along one axis.
  PressureGradient(const PressureGradientSettings& settings, const Observed<Dim>& start,
                   const std::string& key);

  /// pressure_gradient_error [%], positive where the pressure grows too fast with depth; empty
  /// where fewer than two heights are left.
  void addTo(std::vector<Figure>& row, const Observed<Dim>& state) const;

 private:
  double error(const Observed<Dim>& state) const;

  PressureGradientSettings settings_;
  FluidChoice choice_;
  Vertical vertical_;
  double expected_;  // slope upwards [Pa m^(2-d)]
};

extern template class PressureGradient<1>;
extern template class PressureGradient<2>;
extern template class PressureGradient<3>;

}  // namespace plenum
