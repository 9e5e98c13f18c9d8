// SPDX-License-Identifier: GPL-3.0-or-later
//
// The physics of pairs (with engine/common_terms.hpp), each term written once for all dimensions,
// precisions and loops. [C]: Kruisbrink et al. 2018, doi 10.4236/jamp.2018.69158. Units for d
// dimensions.
#pragma once

#include "engine/common_terms.hpp"
#include "engine/pair.hpp"
#include "engine/units.hpp"

#include <cmath>

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

/// Corrects the gradients of the density that DensityDiffusion needs: with
/// b_i = sum_j V_j (rho_j - rho_i) grad_i W_ij and M_i = -sum_j V_j r_ij grad_i W_ij, the gradient
/// of a linear density is M_i^-1 b_i, wherever the neighbours stand. Randles & Libersky 1996,
/// doi 10.1016/S0045-7825(96)01090-0.
struct DensityGradient {
  static constexpr FieldSet reads{field::volume, field::density};
  static constexpr FieldSet writes{field::densityGradient, field::momentDiagonal,
                                   field::momentMixed};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real weight = ij.j.volume * ij.F;
    i.densityGradient += ij.j.volume * (ij.j.density - ij.i.density) * ij.gradW();
    Vec<Dim, Real> diagonal, mixed{};
    for (int a = 0; a < Dim; ++a) diagonal[a] = weight * ij.r[a] * ij.r[a];
    if constexpr (Dim == 2) mixed[0] = weight * ij.r[0] * ij.r[1];
    if constexpr (Dim == 3)
      for (int a = 0; a < 3; ++a) mixed[a] = weight * ij.r[(a + 1) % 3] * ij.r[(a + 2) % 3];
    i.momentDiagonal -= diagonal;
    i.momentMixed -= mixed;
  }
};

/// Diffusion of the density, added to its rate: d rho_i/dt = ... + delta h c sum_j V_j psi_ij .
/// grad_i W_ij, psi_ij = 2 (rho_j - rho_i) r_ji/|r_ij|^2 - (G_i + G_j) with the corrected gradients
/// G. Marrone et al. 2011, doi 10.1016/j.cma.2010.12.016. Written as a part of div v, so that
/// d rho_i/dt = -rho_i div v_i has it.
struct DensityDiffusion {
  static constexpr FieldSet reads{field::volume, field::density, field::specificVolume,
                                  field::densityGradient};
  static constexpr FieldSet writes{field::velocityDivergence};
  static constexpr bool usesKernel = true;

  double delta = 0;
  double soundSpeed = 0;  ///< [m/s]

  DensityDiffusion inUnits(const Units& units) const { return {delta, soundSpeed / units.speed()}; }

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real jump = Real(2) * (ij.i.density - ij.j.density) -
                      dot(ij.i.densityGradient + ij.j.densityGradient, ij.r);
    i.velocityDivergence -=
        Real(delta * soundSpeed) * ij.h * ij.i.specificVolume * ij.j.volume * ij.F * jump;
  }
};

/// What the fluid before a wall particle is like: sum_j V_j p_j W_ij, sum_j m_j r_ij W_ij, and
/// sum_j V_j W_ij to divide them by. Adami, Hu & Adams 2012, doi 10.1016/j.jcp.2012.05.005 (27).
struct FluidAtWall {
  static constexpr FieldSet reads{field::volume, field::mass, field::pressure};
  static constexpr FieldSet writes{field::kernelSum, field::pressure, field::massMoment};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real weight = ij.j.volume * ij.W;
    i.kernelSum += weight;
    i.pressure += weight * ij.j.pressure;
    i.massMoment += ij.j.mass * ij.W * ij.r;
  }
};

/// sum_j V_j v_j W_ij, to be divided by the kernelSum of FluidAtWall: the velocity of the fluid
/// before a wall. Adami et al. 2012 (22).
struct VelocityAtWall {
  static constexpr FieldSet reads{field::volume, field::velocity};
  static constexpr FieldSet writes{field::velocity};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.velocity += ij.j.volume * ij.W * ij.j.velocity;
  }
};

/// Gradient of the concentration of particles, sum_j V_j (1 + 0.2 (W_ij/W(d_ref))^4) grad_i W_ij:
/// where to shift them from. Lind et al. 2012, doi 10.1016/j.jcp.2011.10.027 (23). And
/// -sum_j V_j r_ij . grad_i W_ij, d inside a fluid, less at its surface: Lee et al. 2008,
/// doi 10.1016/j.jcp.2008.06.005.
struct Concentration {
  static constexpr FieldSet reads{field::volume};
  static constexpr FieldSet writes{field::kernelGradient, field::positionDivergence};
  static constexpr bool usesKernel = true;

  double kernelAtSpacing = 1;  ///< W(d_ref) [m^-d]
  int dimension = 3;

  Concentration inUnits(const Units& units) const {
    return {kernelAtSpacing * std::pow(units.length, dimension), dimension};
  }

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real ratio = ij.W * Real(1 / kernelAtSpacing), squared = ratio * ratio;
    i.kernelGradient += ij.j.volume * (Real(1) + Real(0.2) * squared * squared) * ij.gradW();
    i.positionDivergence -= ij.j.volume * ij.F * ij.distanceSquared;
  }
};

/// What Monaghan's viscosities share: m_i m_j Pi_ij   [kg m^(d+2) s^-2], for approaching particles
/// Pi_ij = (-alpha c mu + beta mu^2)/rho_mean, mu = h v_ij.r_ij/(r^2 + softening h^2). Monaghan
/// 1992, doi 10.1146/annurev.aa.30.090192.002551, with a softening of 0.01; [C] has beta = 0. Here
/// with m_i m_j/rho_mean = 2 V_i V_j/(1/rho_i + 1/rho_j). `alphaC` is alpha c of the pair.
struct MonaghanParameters {
  static constexpr FieldSet reads{field::volume, field::specificVolume, field::velocity};

  double alpha = 0;
  double beta = 0;
  double softening = 0.01;

  template <class Real, int Dim>
  [[gnu::always_inline]] Real massesTimesPi(const Pair<Real, Dim>& ij, Real alphaC) const {
    const Real softened = ij.distanceSquared + Real(softening) * ij.h * ij.h;
    const Real specificVolumes = ij.i.specificVolume + ij.j.specificVolume;
    const Real muPerVolume = ij.h * negativePart(ij.velocityDotR) / (softened * specificVolumes);
    const Real mu = muPerVolume * specificVolumes;
    return ij.i.volume * ij.j.volume * (muPerVolume * (Real(2 * beta) * mu - Real(2) * alphaC));
  }
};

/// m_i dv_i/dt = -sum_j m_i m_j Pi_ij grad_i W_ij   [N], where all have the same speed of sound.
struct MonaghanViscosity : MonaghanParameters {
  static constexpr FieldSet reads = MonaghanParameters::reads;
  static constexpr FieldSet writes{field::force};
  static constexpr bool usesKernel = true;

  double soundSpeed = 0;  ///< [m/s]

  MonaghanViscosity inUnits(const Units& units) const {
    MonaghanViscosity scaled = *this;
    scaled.soundSpeed = soundSpeed / units.speed();
    return scaled;
  }

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    i.force -= massesTimesPi(ij, Real(alpha * soundSpeed)) * ij.gradW();
  }
};

/// The same with the mean of the two speeds of sound.
struct MonaghanViscosityOfPhases : MonaghanParameters {
  static constexpr FieldSet reads = MonaghanParameters::reads | FieldSet{field::soundSpeed};
  static constexpr FieldSet writes{field::force};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] Real weight(const Pair<Real, Dim>& ij) const {
    return massesTimesPi(ij, Real(0.5 * alpha) * (ij.i.soundSpeed + ij.j.soundSpeed));
  }
  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    i.force -= weight(ij) * ij.gradW();
  }
};

/// What laminar viscosities share: m_i dv_i/dt = sum_j V_i V_j 2 mu_ij (r_ij.grad_i W_ij)/
/// (r^2 + 0.01 h^2) v_ij   [N]. Morris, Fox & Zhu 1997, doi 10.1006/jcph.1997.5776 (22).
template <class Real, int Dim>
[[gnu::always_inline]] inline void addLaminar(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i,
                                              Real twiceMu) {
  const Real softened = ij.distanceSquared + Real(0.01) * ij.h * ij.h;
  const Real factor = ij.i.volume * ij.j.volume * twiceMu * ij.F * ij.distanceSquared / softened;
  i.force += factor * (ij.i.velocity - ij.j.velocity);
}

/// Laminar viscosity of one fluid.
struct LaminarViscosity {
  static constexpr FieldSet reads{field::volume, field::velocity};
  static constexpr FieldSet writes{field::force};
  static constexpr bool usesKernel = true;

  double dynamicViscosity = 0;  ///< [Pa s m^(3-d)]
  int dimension = 3;

  LaminarViscosity inUnits(const Units& units) const {
    return {dynamicViscosity / units.of(field::dynamicViscosity, dimension), dimension};
  }

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    addLaminar(ij, i, Real(2 * dynamicViscosity));
  }
};

/// Laminar viscosity of several fluids: mu_ij is the harmonic mean, which keeps the shear stress
/// the same on both sides. Cleary & Monaghan 1999, doi 10.1006/jcph.1998.6118. A particle with mu =
/// 0, a wall, takes that of its neighbour.
struct LaminarViscosityOfPhases {
  static constexpr FieldSet reads{field::volume, field::velocity, field::dynamicViscosity};
  static constexpr FieldSet writes{field::force};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    const Real a = ij.i.dynamicViscosity, b = ij.j.dynamicViscosity;
    const Real muI = select(Real(0) < a, a, b), muJ = select(Real(0) < b, b, a);
    addLaminar(ij, i, Real(4) * muI * muJ / (muI + muJ));
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
