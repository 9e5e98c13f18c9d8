// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observed.hpp"
#include "solver/measures/riemann_problem.hpp"

namespace plenum {

/// Distance of a run from the exact solution of a Riemann problem.
template <int Dim>
class ShockTube {
 public:
  /// Throws InputError that names `key` and what is wrong with it: not a gas, a pressure missing or
  /// too many, vacuum.
  ShockTube(const RiemannSettings& settings, const Observed<Dim>& start, const std::string& key);

  const RiemannProblem& exact() const { return exact_; }

  /// l1_density, l1_velocity [m/s], l1_pressure, l1_internal_energy (ideal gas), velocity_noise
  /// [m/s], shock_width [h]; defined in docs/measures.md. NaN where nothing is to be measured.
  void addTo(std::vector<Figure>& row, const Observed<Dim>& state) const;

 private:
  struct Plateau {  // where the gas behind the shock stays as it is, in x/t [m/s]
    double lower, upper;
  };
  const RiemannProblem::Wave& shock() const;
  bool hasShock() const { return exact_.left().isShock || exact_.right().isShock; }
  Plateau plateau() const;
  /// x less the jump's first place, and x/t [m/s].
  double place(const Observed<Dim>& state, std::size_t i) const;
  double speedAt(double place, double time) const;
  bool isInWindow(const Observed<Dim>& state, std::size_t i) const;
  void addErrors(std::vector<Figure>& row, const Observed<Dim>& state) const;
  double velocityNoise(const Observed<Dim>& state) const;
  double shockWidth(const Observed<Dim>& state) const;

  RiemannSettings settings_;
  int axis_;
  double gamma_;  // 1: isothermal
  RiemannProblem exact_;
};

extern template class ShockTube<1>;
extern template class ShockTube<2>;
extern template class ShockTube<3>;

}  // namespace plenum
