// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observed.hpp"

namespace plenum {

/// Distance from the vortex of Gresho & Chan (1990, doi 10.1002/fld.1650110510), in which
/// centrifugal forces and pressure balance: v_phi grows linearly up to U at the radius a, falls
/// linearly to zero at 2 a, and stays so. Pressures of gases: Liska & Wendroff (2003, doi
/// 10.1137/S1064827502402120), p = p0 + rho0 U^2 (...).
template <int Dim>
class Gresho {
 public:
  /// Throws InputError that names `key` if the gas is not ideal.
  Gresho(const GreshoSettings& settings, const Observed<Dim>& start, const std::string& key);

  /// v_phi [m/s] at a distance from the axis [m].
  double speed(double radius) const;
  /// Pressure less that on the axis, over rho0   [m^2/s^2]; a gas of uniform density rho0.
  double pressureOverDensity(double radius) const;

  /// l1_velocity [m/s]: mean of |v_phi - exact| over the particles of the square of edge 5 a around
  /// the drifting axis (that box is what is published); l1_velocity_profile [m/s]: the same of the
  /// means of v_phi in rings of width a/20. NaN without particles.
  void addTo(std::vector<Figure>& row, const Observed<Dim>& state) const;

 private:
  GreshoSettings settings_;
  Vec<Dim> center_, drift_;
};

extern template class Gresho<2>;
extern template class Gresho<3>;

}  // namespace plenum
