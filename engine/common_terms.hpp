// SPDX-License-Identifier: GPL-3.0-or-later
//
// Terms that a flow and the making of its initial conditions share. Units for d dimensions.
// [C]: Kruisbrink et al. 2018, doi 10.4236/jamp.2018.69158.
#pragma once

#include "engine/pair.hpp"

namespace plenum::term {

/// rho_i = sum_j m_j W_ij(h_i), the particle itself included   [kg m^-d].  [C] (2.2).
struct DensitySum {
  static constexpr FieldSet reads{field::mass};
  static constexpr FieldSet writes{field::density};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.density += ij.j.mass * ij.ofI.W;
  }
};

/// m_i dv_i/dt = -sum_j V_i V_j (p_i + p_j) grad_i W_ij, V = m/rho   [N].  [C] (5.24); the partner
/// of Continuity.
struct PressureDensityProduct {
  static constexpr FieldSet reads{field::volume, field::pressure};
  static constexpr FieldSet writes{field::force};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    i.force -= ij.i.volume * ij.j.volume * (ij.i.pressure + ij.j.pressure) * ij.gradW();
  }
};

}  // namespace plenum::term
