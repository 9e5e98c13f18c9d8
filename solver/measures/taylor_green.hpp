// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observed.hpp"

namespace plenum {

/// Distance from the decaying vortices of Taylor and Green, an exact solution of the
/// incompressible Navier-Stokes equations in a periodic square (Taylor & Green 1937, doi
/// 10.1098/rspa.1937.0036):
/// u = -U e^bt cos kx sin ky, v = U e^bt sin kx cos ky,
/// p = -rho0 U^2/4 e^2bt (cos 2kx + cos 2ky), with k = 2 pi/L and b = -2 nu k^2.
class TaylorGreen {
 public:
  explicit TaylorGreen(const TaylorGreenSettings& settings);

  Vec<2> velocity(const Vec<2>& x, double time) const;               ///< [m/s]
  double pressure(const Vec<2>& x, double time, double rho0) const;  ///< [Pa m]

  /// l1_velocity = sum |v - v_ref| / sum |v_ref| and l1_pressure, the same for pressures less their
  /// mean over the particles; all fluid particles count alike.
  void addTo(std::vector<Figure>& row, const Observed<2>& state) const;

 private:
  Vec<2> phase(const Vec<2>& x) const;  // k (x - origin)
  double speed(double time) const;      // U e^bt

  TaylorGreenSettings settings_;
  double k_;
};

}  // namespace plenum
