// SPDX-License-Identifier: GPL-3.0-or-later
//
// The physics of pairs (with engine/common_terms.hpp), each term written once for all dimensions,
// precisions and loops. [C]: Kruisbrink et al. 2018, doi 10.4236/jamp.2018.69158. Units for d
// dimensions.
#pragma once

#include "engine/common_terms.hpp"
#include "engine/pair.hpp"
#include "engine/units.hpp"

namespace plenum::term {

/// div v_i = -sum_j (m_j/rho_j) v_ij . grad_i W_ij   [1/s]; then d rho_i/dt = -rho_i div v_i is
/// [C] (5.23).
struct Continuity {
  static constexpr FieldSet reads{field::volume, field::velocity};
  static constexpr FieldSet writes{field::velocityDivergence};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.velocityDivergence -= ij.j.volume * ij.velocityDotGradW();
  }
};

/// m_i dv_i/dt = -sum_j m_i m_j (p_i/rho_i^2 + p_j/rho_j^2) grad_i W_ij   [N].  [C] (2.3);
/// the partner of DensitySum.
struct PressureDensitySquared {
  static constexpr FieldSet reads{field::mass, field::pressureOverDensitySquared};
  static constexpr FieldSet writes{field::force};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    i.force -= ij.i.mass * ij.j.mass *
               (ij.i.pressureOverDensitySquared + ij.j.pressureOverDensitySquared) * ij.gradW();
  }
};

/// m_i dv_i/dt = -sum_j m_i m_j Pi_ij grad_i W_ij, for approaching particles
/// Pi_ij = (-alpha c mu + beta mu^2)/rho_mean, mu = h v_ij.r_ij/(r^2 + 0.01 h^2)   [N].
/// Monaghan 1992, doi 10.1146/annurev.aa.30.090192.002551; [C] has beta = 0. Here with
/// m_i m_j/rho_mean = 2 V_i V_j/(1/rho_i + 1/rho_j).
struct MonaghanViscosity {
  static constexpr FieldSet reads{field::volume, field::specificVolume, field::velocity};
  static constexpr FieldSet writes{field::force};
  static constexpr bool usesKernel = true;

  double alpha = 0;
  double beta = 0;
  double soundSpeed = 0;  ///< [m/s]

  MonaghanViscosity inUnits(const Units& units) const {
    return {alpha, beta, soundSpeed / units.speed()};
  }

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    const Real softened = ij.distanceSquared + Real(0.01) * ij.h * ij.h;
    const Real specificVolumes = ij.i.specificVolume + ij.j.specificVolume;
    const Real muPerVolume = ij.h * negativePart(ij.velocityDotR) / (softened * specificVolumes);
    const Real mu = muPerVolume * specificVolumes;
    i.force -= ij.i.volume * ij.j.volume *
               (muPerVolume * (Real(2 * beta) * mu - Real(2 * alpha * soundSpeed))) * ij.gradW();
  }
};

/// Change of momentum [N s] by collisions of approaching particles closer than `range`:
/// -sum_j m_i m_j/(m_i + m_j) (1 + C_R) (u_ij.r_ij) r_ij/r_ij^2.  [C] (4.20), which does not say
/// that only approaching pairs collide: on all close pairs it heats a gas at rest.
struct Collision {
  static constexpr FieldSet reads{field::mass, field::velocity};
  static constexpr FieldSet writes{field::impulse};
  static constexpr bool usesKernel = false;

  double restitution = 0;  ///< C_R
  double range = 0;        ///< delta_c d_ref [m]

  Collision inUnits(const Units& units) const { return {restitution, range / units.length}; }

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    const Real tiny = Real(1e-12 * range * range);  // coincident particles do not collide
    const Real approach =
        select(ij.distanceSquared < Real(range * range), negativePart(ij.velocityDotR), Real(0));
    i.impulse -= ij.i.mass * ij.j.mass / (ij.i.mass + ij.j.mass) * Real(1 + restitution) *
                 approach / max(ij.distanceSquared, tiny) * ij.r;
  }
};

}  // namespace plenum::term
