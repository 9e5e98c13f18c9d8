// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observed.hpp"

namespace plenum {

/// Distance from the implosion of Noh (1987, doi 10.1016/0021-9991(87)90074-X): cold gas of uniform
/// density runs into itself with speed v0. A shock at r_s = (gamma - 1)/2 v0 t stops it; behind it
/// rho = rho0 ((gamma + 1)/(gamma - 1))^d, ahead of it rho = rho0 (1 + v0 t/r)^(d - 1).
template <int Dim>
class Noh {
 public:
  /// Throws InputError that names `key` if the gas is not ideal.
  Noh(const NohSettings& settings, const Observed<Dim>& start, const std::string& key);

  double shockRadius(double time) const;             ///< r_s [m]
  double densityBehind() const;                      ///< [kg/m^d]
  double density(double radius, double time) const;  ///< [kg/m^d]

  /// l1_density: mean of |rho - exact| over the volume of the particles that count, over the exact
  /// density behind the shock; density_behind_shock: sum m / sum V within 0.8 r_s, over the exact
  /// one. NaN where there are no particles.
  void addTo(std::vector<Figure>& row, const Observed<Dim>& state) const;

 private:
  double countedRadius(double time) const;

  NohSettings settings_;
  Vec<Dim> center_;
  double gamma_;
};

extern template class Noh<1>;
extern template class Noh<2>;
extern template class Noh<3>;

}  // namespace plenum
