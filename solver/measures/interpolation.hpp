// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/point_search.hpp"
#include "solver/measures/observed.hpp"

namespace plenum {

/// SPH sums at places where no particle stands, with the run's kernel and V_j = m_j/rho_j. Built
/// once a row for all measures that need it.
template <int Dim>
class Interpolation {
 public:
  explicit Interpolation(const Observed<Dim>& state);

  struct Sums {
    double fluid = 0;     ///< sum V W over the fluid that counts: its share of the place
    double walls = 0;     ///< the same over walls
    double pressure = 0;  ///< sum V p W over that fluid [Pa m^(3-d)]
    Vec<Dim> velocity{};  ///< sum V v W over that fluid [m/s]
  };
  Sums at(const Vec<Dim>& x, const FluidChoice& counted) const;

  /// Share of the place, as far as no wall takes it, that is fluid: sum V W of the fluid over
  /// 1 - sum V W of the walls, so that a surface is at 0.5 beside a wall, too; 0 inside walls.
  double fluidFraction(const Vec<Dim>& x, const FluidChoice& counted) const;

  const Observed<Dim>& state() const { return state_; }
  double support() const { return 2 * state_.smoothingLength; }

 private:
  Observed<Dim> state_;
  kernel::Any profile_;
  double atZero_;  // sigma_d h^-d [m^-d]
  PointSearch<Dim> search_;
};

extern template class Interpolation<1>;
extern template class Interpolation<2>;
extern template class Interpolation<3>;

}  // namespace plenum
