// SPDX-License-Identifier: GPL-3.0-or-later
//
// The physics of pairs in a gas, where particles have smoothing lengths and energies of their own:
// as in terms.hpp, each term once for all dimensions, precisions and loops. Sources: Springel &
// Hernquist 2002, doi 10.1046/j.1365-8711.2002.05445.x; Price 2012, doi 10.1016/j.jcp.2010.12.011;
// [A] is the page on adaptive smoothing lengths. Units for d dimensions.
#pragma once

#include "solver/terms.hpp"

namespace plenum::term {

/// Omega_i rho_i = -1/d sum_j m_j r_ij . grad_i W_ij(h_i)   [kg m^-d]. With h rho^(1/d) constant,
/// Omega = 1 + h/(d rho) sum_j m_j dW_ij/dh, and h dW/dh = -d W - r . grad W. Price 2012 (27).
struct OmegaDensity {
  static constexpr FieldSet reads{field::mass};
  static constexpr FieldSet writes{field::omegaDensity};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.omegaDensity -= Real(1.0 / Dim) * ij.j.mass * ij.ofI.F * ij.distanceSquared;
  }
};

/// <rho^2>_i = sum_j m_j rho_j W_ij(h_i)   [kg^2 m^-2d]; [A]'s mean density is this over rho_i.
struct DensityMoment {
  static constexpr FieldSet reads{field::mass, field::density};
  static constexpr FieldSet writes{field::densityMoment};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.densityMoment += ij.j.mass * ij.j.density * ij.ofI.W;
  }
};

/// Omega_i d rho_i/dt = sum_j m_j v_ij . grad_i W_ij(h_i)   [kg m^-d s^-1]; div v_i is minus this
/// over Omega_i rho_i.
struct DensityRate {
  static constexpr FieldSet reads{field::mass, field::velocity};
  static constexpr FieldSet writes{field::densityRate};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.densityRate += ij.j.mass * ij.ofI.F * ij.velocityDotR;
  }
};

/// Omega_i rho_i curl v_i = sum_j m_j v_ij x grad_i W_ij(h_i)   [kg m^-d s^-1]; in 2-D its z is the
/// first component, in 1-D there is none.
struct VelocityCurl {
  static constexpr FieldSet reads{field::mass, field::velocity};
  static constexpr FieldSet writes{field::velocityCurl};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Vec<Dim, Real> v = ij.i.velocity - ij.j.velocity;
    const Real weight = ij.j.mass * ij.ofI.F;
    Vec<Dim, Real> curl{};
    if constexpr (Dim == 2) curl[0] = weight * (v[0] * ij.r[1] - v[1] * ij.r[0]);
    if constexpr (Dim == 3)
      for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        curl[a] = weight * (v[b] * ij.r[c] - v[c] * ij.r[b]);
      }
    i.velocityCurl += curl;
  }
};

/// m_i dv_i/dt = -sum_j m_i m_j (P_i grad_i W_ij(h_i) + P_j grad_i W_ij(h_j))   [N], P =
/// p/(Omega rho^2). Springel & Hernquist 2002 (18). Its partner, de_i/dt = P_i sum_j m_j v_ij .
/// grad_i W_ij(h_i), is P_i times DensityRate: no sum of its own.
struct PressureGradH {
  static constexpr FieldSet reads{field::mass, field::pressureOverDensitySquared};
  static constexpr FieldSet writes{field::force};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    i.force -= (ij.i.mass * ij.j.mass *
                (ij.i.pressureOverDensitySquared * ij.ofI.F +
                 ij.j.pressureOverDensitySquared * ij.ofJ.F)) *
               ij.alongR();
  }
};

/// m_i de_i/dt = sum_j m_i m_j P_i v_ij . grad_i W_ij   [W]; the partner of PressureDensitySquared.
/// Monaghan 1992, doi 10.1146/annurev.aa.30.090192.002551.
struct PressureWork {
  static constexpr FieldSet reads{field::mass, field::velocity, field::pressureOverDensitySquared};
  static constexpr FieldSet writes{field::power};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.power += ij.i.mass * ij.j.mass * ij.i.pressureOverDensitySquared * ij.velocityDotGradW();
  }
};

/// What a viscosity of weight m_i m_j Pi_ij takes from the motion heats both particles alike:
/// m_i de_i/dt = 1/2 sum_j m_i m_j Pi_ij v_ij . grad_i W_ij   [W]. Monaghan 1992.
template <class Real, int Dim>
[[gnu::always_inline]] inline void addHeatingViscosity(Real weight, const Pair<Real, Dim>& ij,
                                                       Exchange<Real, Dim>& i,
                                                       Sums<Real, Dim>& each) {
  i.force -= weight * ij.gradW();
  each.power += Real(0.5) * weight * ij.velocityDotGradW();
}

/// MonaghanViscosityOfPhases, and its heat.
struct HeatingViscosity : MonaghanViscosityOfPhases {
  static constexpr FieldSet writes{field::force, field::power};

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i,
                                         Sums<Real, Dim>& each) const {
    addHeatingViscosity(weight(ij), ij, i, each);
  }
};

/// The same times the mean of the two particles' limiters, Balsara 1995,
/// doi 10.1016/S0021-9991(95)90221-X.
struct BalsaraViscosity : HeatingViscosity {
  static constexpr FieldSet reads = HeatingViscosity::reads | FieldSet{field::viscosityLimiter};

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i,
                                         Sums<Real, Dim>& each) const {
    const Real limiter = Real(0.5) * (ij.i.viscosityLimiter + ij.j.viscosityLimiter);
    addHeatingViscosity(limiter * weight(ij), ij, i, each);
  }
};

/// m_i de_i/dt = sum_j m_i m_j/rho_mean alpha v_sig (e_i - e_j) |r_ij| F_ij   [W], with the signal
/// speed v_sig = sqrt(|p_i - p_j|/rho_mean): heat crosses a contact only while the pressure has a
/// blip there. Price 2008, doi 10.1016/j.jcp.2008.08.011 (28).
struct Conductivity {
  static constexpr FieldSet reads{field::volume, field::specificVolume, field::pressure,
                                  field::internalEnergy};
  static constexpr FieldSet writes{field::power};
  static constexpr bool usesKernel = true;

  double alpha = 0;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Exchange<Real, Dim>& i) const {
    const Real specificVolumes = ij.i.specificVolume + ij.j.specificVolume;
    const Real jump = ij.i.pressure - ij.j.pressure;
    const Real inverseMean = Real(2) * ij.i.specificVolume * ij.j.specificVolume / specificVolumes;
    const Real squares = max(jump, -jump) * inverseMean * ij.distanceSquared;
    i.power += Real(2 * alpha) * ij.i.volume * ij.j.volume / specificVolumes * squareRoot(squares) *
               (ij.i.internalEnergy - ij.j.internalEnergy) * ij.F;
  }
};

}  // namespace plenum::term
