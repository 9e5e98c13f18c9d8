// SPDX-License-Identifier: GPL-3.0-or-later
//
// The physics of pairs, each term written once for all dimensions, precisions and loops.
// [C]: Kruisbrink et al. 2018, doi 10.4236/jamp.2018.69158. Units for d dimensions.
#pragma once

#include "engine/pair.hpp"
#include "engine/units.hpp"

namespace plenum::term {

/// rho_i = sum_j m_j W_ij, the particle itself included   [kg m^-d].  [C] (2.2).
struct DensitySum {
  static constexpr FieldSet reads{field::mass};
  static constexpr FieldSet writes{field::density};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.density += ij.j.mass * ij.W;
  }
};

/// d rho_i/dt = rho_i sum_j (m_j/rho_j) v_ij . grad_i W_ij   [kg m^-d s^-1].  [C] (5.23).
struct Continuity {
  static constexpr FieldSet reads{field::mass, field::density, field::velocity};
  static constexpr FieldSet writes{field::densityRate};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.densityRate += ij.i.density * ij.j.mass * ij.j.inverseDensity * ij.velocityDotGradW();
  }
};

/// dv_i/dt = -sum_j m_j (p_i/rho_i^2 + p_j/rho_j^2) grad_i W_ij   [m s^-2].  [C] (2.3);
/// the partner of DensitySum.
struct PressureDensitySquared {
  static constexpr FieldSet reads{field::mass, field::density, field::pressure};
  static constexpr FieldSet writes{field::acceleration};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real stress = ij.i.pressure * (ij.i.inverseDensity * ij.i.inverseDensity) +
                        ij.j.pressure * (ij.j.inverseDensity * ij.j.inverseDensity);
    i.acceleration -= ij.j.mass * stress * ij.gradW();
  }
};

/// dv_i/dt = -sum_j m_j (p_i + p_j)/(rho_i rho_j) grad_i W_ij   [m s^-2].  [C] (5.24);
/// the partner of Continuity.
struct PressureDensityProduct {
  static constexpr FieldSet reads{field::mass, field::density, field::pressure};
  static constexpr FieldSet writes{field::acceleration};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real stress =
        (ij.i.pressure + ij.j.pressure) * (ij.i.inverseDensity * ij.j.inverseDensity);
    i.acceleration -= ij.j.mass * stress * ij.gradW();
  }
};

/// dv_i/dt = -sum_j m_j Pi_ij grad_i W_ij, for approaching particles
/// Pi_ij = (-alpha c mu + beta mu^2)/rho_mean, mu = h v_ij.r_ij/(r^2 + 0.01 h^2)   [m s^-2].
/// Monaghan 1992, doi 10.1146/annurev.aa.30.090192.002551; [C] has beta = 0.
struct MonaghanViscosity {
  static constexpr FieldSet reads{field::density, field::mass, field::velocity};
  static constexpr FieldSet writes{field::acceleration};
  static constexpr bool usesKernel = true;

  double alpha = 0;
  double beta = 0;
  double soundSpeed = 0;  ///< [m/s]

  MonaghanViscosity inUnits(const Units& units) const {
    return {alpha, beta, soundSpeed / units.speed()};
  }

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real meanDensity = Real(0.5) * (ij.i.density + ij.j.density);
    const Real softened = ij.distanceSquared + Real(0.01) * ij.h * ij.h;
    const Real muOverDensity = ij.h * negativePart(ij.velocityDotR) / (softened * meanDensity);
    const Real mu = muOverDensity * meanDensity;
    const Real Pi = muOverDensity * (Real(beta) * mu - Real(alpha * soundSpeed));
    i.acceleration -= ij.j.mass * Pi * ij.gradW();
  }
};

/// Change of velocity [m/s] by collisions of approaching particles closer than `range`:
/// -sum_j m_j/(m_i + m_j) (1 + C_R) (u_ij.r_ij) r_ij/r_ij^2.  [C] (4.20), which does not say that
/// only approaching pairs collide: on all close pairs it heats a gas at rest.
struct Collision {
  static constexpr FieldSet reads{field::mass, field::velocity};
  static constexpr FieldSet writes{field::velocityChange};
  static constexpr bool usesKernel = false;

  double restitution = 0;  ///< C_R
  double range = 0;        ///< delta_c d_ref [m]

  Collision inUnits(const Units& units) const { return {restitution, range / units.length}; }

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real tiny = Real(1e-12 * range * range);  // coincident particles do not collide
    const Real approach =
        select(ij.distanceSquared < Real(range * range), negativePart(ij.velocityDotR), Real(0));
    i.velocityChange -= ij.j.mass / (ij.i.mass + ij.j.mass) * Real(1 + restitution) * approach /
                        max(ij.distanceSquared, tiny) * ij.r;
  }
};

}  // namespace plenum::term
