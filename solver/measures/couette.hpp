// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observed.hpp"

namespace plenum {

/// Distance from the steady flow between two rotating cylinders (Couette 1890):
/// u_theta = A r + B/r with A = (w2 r2^2 - w1 r1^2)/(r2^2 - r1^2), B = (w1 - w2) r1^2 r2^2 /
/// (r2^2 - r1^2).
class Couette {
 public:
  explicit Couette(const CouetteSettings& settings);

  /// u_theta [m/s] at a distance from the axis [m]; beyond the cylinders as at their surface.
  double speed(double radius) const;

  /// l1_velocity = sum |v - v_ref| / sum |v_ref| over all fluid particles, and
  /// couette_profile_error: the largest difference of the means of u_theta and of its reference
  /// over the particles of a ring, relative to the larger speed of the two cylinders. Rings without
  /// particles do not count.
  void addTo(std::vector<Figure>& row, const Observed<2>& state) const;

 private:
  double profileError(const Observed<2>& state) const;
  Vec<2> fromCenter(const Vec<2>& x) const;

  CouetteSettings settings_;
  double A_, B_;  // [1/s], [m^2/s]
};

}  // namespace plenum
