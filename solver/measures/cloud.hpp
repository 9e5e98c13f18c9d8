// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observed.hpp"

namespace plenum {

/// How much of a dense cloud in a wind is left (Agertz et al. 2007, doi
/// 10.1111/j.1365-2966.2007.12183.x).
template <int Dim>
class Cloud {
 public:
  /// Throws InputError that names `key` if the gas is not ideal.
  Cloud(const CloudSettings& settings, const Observed<Dim>& start, const std::string& key);

  double kelvinHelmholtzTime() const;  ///< tau_KH = 1.6 t_crush, t_crush = 2 R sqrt(chi)/v [s]
  double mass() const;                 ///< of a ball of the cloud's density and radius

  /// cloud_mass: mass of the gas with rho > 0.64 rho_cloud and e < 0.9 e_wind (temperature and
  /// internal energy are proportional), over that of the ball; time_over_tau_kh.
  void addTo(std::vector<Figure>& row, const Observed<Dim>& state) const;

 private:
  CloudSettings settings_;
};

extern template class Cloud<1>;
extern template class Cloud<2>;
extern template class Cloud<3>;

}  // namespace plenum
