// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a physics term sees. A term is a small function object
//
//   struct Term {
//     static constexpr FieldSet reads{...};   // members of ij.i and ij.j that it uses
//     static constexpr FieldSet writes{...};  // members of Sums or Exchange that it adds to
//     template <class Real, int Dim>
//     void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const;
//   };
//
// that adds what particle i gets from j, or takes an Exchange: what i gets and j loses, so that the
// pair is computed once and momentum is conserved to the last digit of a sum. A third form takes
// both, (ij, Exchange& i, Sums& each): what each of the two gets alike is computed once, too.
//
// A term knows neither loop nor layout nor how many pairs it sees at once: `Real` is a number or a
// pack. As in the formulas, sums run over all neighbours and the particle itself (r_ij = 0).
#pragma once

#include "particles/field.hpp"
#include "particles/number.hpp"
#include "particles/vec.hpp"

#include <type_traits>

namespace plenum {

/// A field known at compile time, so that loops load and store only what a term names.
template <FieldId Id>
using FieldTag = std::integral_constant<FieldId, Id>;

/// The fields of one particle that terms may read.
template <class Real, int Dim>
struct ParticleView {
  Vec<Dim, Real> velocity;
  Real mass;
  Real density;
  Real pressure;
  Real smoothingLength;
  Real volume;                      ///< m/rho
  Real specificVolume;              ///< 1/rho
  Real pressureOverDensitySquared;  ///< p/rho^2
  Real dynamicViscosity;
  Real soundSpeed;
  Real internalEnergy;
  Real viscosityLimiter;
  Vec<Dim, Real> densityGradient;

  template <class Visit>
  [[gnu::always_inline]] static constexpr void forEachMember(Visit&& visit) {
    visit(FieldTag<FieldId::velocity>{}, &ParticleView::velocity);
    visit(FieldTag<FieldId::mass>{}, &ParticleView::mass);
    visit(FieldTag<FieldId::density>{}, &ParticleView::density);
    visit(FieldTag<FieldId::pressure>{}, &ParticleView::pressure);
    visit(FieldTag<FieldId::smoothingLength>{}, &ParticleView::smoothingLength);
    visit(FieldTag<FieldId::volume>{}, &ParticleView::volume);
    visit(FieldTag<FieldId::specificVolume>{}, &ParticleView::specificVolume);
    visit(FieldTag<FieldId::pressureOverDensitySquared>{},
          &ParticleView::pressureOverDensitySquared);
    visit(FieldTag<FieldId::dynamicViscosity>{}, &ParticleView::dynamicViscosity);
    visit(FieldTag<FieldId::soundSpeed>{}, &ParticleView::soundSpeed);
    visit(FieldTag<FieldId::internalEnergy>{}, &ParticleView::internalEnergy);
    visit(FieldTag<FieldId::viscosityLimiter>{}, &ParticleView::viscosityLimiter);
    visit(FieldTag<FieldId::densityGradient>{}, &ParticleView::densityGradient);
  }
};

/// factor grad_i W_ij
template <class Real>
struct TimesGradW {
  Real factor;
  [[gnu::always_inline]] friend TimesGradW operator*(Real s, TimesGradW g) {
    return {s * g.factor};
  }
};
struct GradW {
  template <class Real>
  [[gnu::always_inline]] friend TimesGradW<Real> operator*(Real s, GradW) {
    return {s};
  }
};

/// factor r_ij
template <class Real>
struct TimesR {
  Real factor;
};
struct AlongR {
  template <class Real>
  [[gnu::always_inline]] friend TimesR<Real> operator*(Real s, AlongR) {
    return {s};
  }
};

/// A vector that a pair adds to. Most terms point along grad_i W_ij or r_ij: their factors are
/// added up before the one multiplication by the vector.
template <class Real, int Dim>
struct VectorSum {
  Real alongGradW{0};
  Real alongR{0};
  Vec<Dim, Real> rest{};

  // Inline in any case: g++ makes these many numbers a call of their own, 2 times the rest of a
  // pair.
  [[gnu::always_inline]] VectorSum() {}
  [[gnu::always_inline]] VectorSum& operator+=(const TimesGradW<Real>& g) {
    alongGradW += g.factor;
    return *this;
  }
  [[gnu::always_inline]] VectorSum& operator-=(const TimesGradW<Real>& g) {
    alongGradW -= g.factor;
    return *this;
  }
  [[gnu::always_inline]] VectorSum& operator+=(const TimesR<Real>& g) {
    alongR += g.factor;
    return *this;
  }
  [[gnu::always_inline]] VectorSum& operator-=(const TimesR<Real>& g) {
    alongR -= g.factor;
    return *this;
  }
  [[gnu::always_inline]] VectorSum& operator+=(const Vec<Dim, Real>& v) {
    rest += v;
    return *this;
  }
  [[gnu::always_inline]] VectorSum& operator-=(const Vec<Dim, Real>& v) {
    rest -= v;
    return *this;
  }
  /// With grad_i W_ij = F r.
  [[gnu::always_inline]] Vec<Dim, Real> total(Real F, const Vec<Dim, Real>& r) const {
    return (alongGradW * F + alongR) * r + rest;
  }
};

/// The fields of particle i that terms may add to.
template <class Real, int Dim>
struct Sums {
  Real density{0};
  Real velocityDivergence{0};
  Real kernelSum{0};
  Real pressure{0};
  Real positionDivergence{0};
  Real omegaDensity{0};
  Real densityRate{0};
  Real densityMoment{0};
  Real power{0};
  VectorSum<Real, Dim> velocityCurl;
  VectorSum<Real, Dim> kernelGradient;
  VectorSum<Real, Dim> push;
  VectorSum<Real, Dim> acceleration;  ///< what is no exchange: for terms that are not symmetric
  VectorSum<Real, Dim> velocity;
  VectorSum<Real, Dim> massMoment;
  VectorSum<Real, Dim> densityGradient;
  VectorSum<Real, Dim> momentDiagonal;
  VectorSum<Real, Dim> momentMixed;

  [[gnu::always_inline]] Sums() {}

  template <class Visit>
  [[gnu::always_inline]] static constexpr void forEachMember(Visit&& visit) {
    visit(FieldTag<FieldId::density>{}, &Sums::density);
    visit(FieldTag<FieldId::velocityDivergence>{}, &Sums::velocityDivergence);
    visit(FieldTag<FieldId::kernelSum>{}, &Sums::kernelSum);
    visit(FieldTag<FieldId::kernelGradient>{}, &Sums::kernelGradient);
    visit(FieldTag<FieldId::push>{}, &Sums::push);
    visit(FieldTag<FieldId::acceleration>{}, &Sums::acceleration);
    visit(FieldTag<FieldId::pressure>{}, &Sums::pressure);
    visit(FieldTag<FieldId::positionDivergence>{}, &Sums::positionDivergence);
    visit(FieldTag<FieldId::omegaDensity>{}, &Sums::omegaDensity);
    visit(FieldTag<FieldId::densityRate>{}, &Sums::densityRate);
    visit(FieldTag<FieldId::densityMoment>{}, &Sums::densityMoment);
    visit(FieldTag<FieldId::power>{}, &Sums::power);
    visit(FieldTag<FieldId::velocityCurl>{}, &Sums::velocityCurl);
    visit(FieldTag<FieldId::velocity>{}, &Sums::velocity);
    visit(FieldTag<FieldId::massMoment>{}, &Sums::massMoment);
    visit(FieldTag<FieldId::densityGradient>{}, &Sums::densityGradient);
    visit(FieldTag<FieldId::momentDiagonal>{}, &Sums::momentDiagonal);
    visit(FieldTag<FieldId::momentMixed>{}, &Sums::momentMixed);
  }
};

/// What particle i gets from j and j loses.
template <class Real, int Dim>
struct Exchange {
  Real power{0};
  VectorSum<Real, Dim> force;
  VectorSum<Real, Dim> impulse;

  [[gnu::always_inline]] Exchange() {}

  template <class Visit>
  [[gnu::always_inline]] static constexpr void forEachMember(Visit&& visit) {
    visit(FieldTag<FieldId::power>{}, &Exchange::power);
    visit(FieldTag<FieldId::force>{}, &Exchange::force);
    visit(FieldTag<FieldId::impulse>{}, &Exchange::impulse);
  }
};

/// The kernel for one smoothing length: W [m^-d], and the factor F [m^-(d+2)] of its gradient,
/// grad_i W_ij = F r_ij.
template <class Real>
struct KernelValues {
  Real W, F;
};

/// A pair of neighbours. Units are SI in the formulas; loops may compute in others (units.hpp).
/// Where particles have smoothing lengths of their own, h, W and F are the
/// means of those of i and j.
template <class Real, int Dim>
struct Pair {
  const ParticleView<Real, Dim>& i;
  const ParticleView<Real, Dim>& j;
  Vec<Dim, Real> r;      ///< r_ij = r_i - r_j, nearest periodic image [m]
  Real distanceSquared;  ///< |r_ij|^2 [m^2]
  Real velocityDotR;     ///< v_ij . r_ij [m^2/s]; negative for approaching particles
  Real h;                ///< smoothing length [m]
  Real W, F;
  KernelValues<Real> ofI, ofJ;  ///< with the smoothing length of i (gather), and of j (scatter)

  /// v_ij . grad_i W_ij [m^-d s^-1]
  [[gnu::always_inline]] Real velocityDotGradW() const { return F * velocityDotR; }
  /// grad_i W_ij [m^-(d+1)]
  [[gnu::always_inline]] GradW gradW() const { return {}; }
  /// r_ij, as a factor
  [[gnu::always_inline]] AlongR alongR() const { return {}; }
};

/// Whether a term exchanges something between the two, or adds to one of them.
template <class Term, class Real, int Dim>
concept Exchanges = requires(const Term& term, const Pair<Real, Dim>& ij, Exchange<Real, Dim>& e) {
  term(ij, e);
};

/// Whether a term exchanges something and gives something to each alike.
template <class Term, class Real, int Dim>
concept ExchangesAndGives = requires(const Term& term, const Pair<Real, Dim>& ij,
                                     Exchange<Real, Dim>& e, Sums<Real, Dim>& each) {
  term(ij, e, each);
};

}  // namespace plenum
