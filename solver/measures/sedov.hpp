// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observed.hpp"
#include "solver/measures/sedov_blast.hpp"

namespace plenum {

/// Distance of a run from Sedov's point explosion.
template <int Dim>
class Sedov {
 public:
  /// Throws InputError that names `key` if the gas is not ideal or its gamma is too large.
  Sedov(const SedovSettings& settings, const Observed<Dim>& start, const std::string& key);

  const SedovBlast& exact() const { return exact_; }
  double shockRadius(double time) const;             ///< [m]
  double density(double radius, double time) const;  ///< [kg/m^d]

  /// l1_density: mean of |rho - exact| over the volume of the particles within 1.2 R, over the
  /// density around. shock_radius [m] and peak_density: where the mean density of shells of width
  /// d_ref is largest, and how large over the exact (gamma + 1)/(gamma - 1) rho0.
  void addTo(std::vector<Figure>& row, const Observed<Dim>& state) const;

 private:
  struct Peak {
    double radius, density;  // NaN without particles
  };
  double radiusOf(const Observed<Dim>& state, std::size_t i) const;
  Peak peak(const Observed<Dim>& state) const;

  SedovSettings settings_;
  Vec<Dim> center_;
  double gamma_;
  SedovBlast exact_;
};

extern template class Sedov<1>;
extern template class Sedov<2>;
extern template class Sedov<3>;

}  // namespace plenum
