// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a physics term sees. A term is a small function object
//
//   struct Term {
//     static constexpr FieldSet reads{...};   // members of ij.i and ij.j that it uses
//     static constexpr FieldSet writes{...};  // members of Sums that it adds to
//     template <class Real, int Dim>
//     void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const;
//     template <class Real, int Dim>          // optional: what a particle adds to itself
//     void self(const ParticleView<Real, Dim>& i, Real W0, Sums<Real, Dim>& sums) const;
//   };
//
// It knows neither loop nor layout nor how many pairs it sees at once: `Real` is a number or a
// pack.
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
  Real mass;
  Real density;
  Real pressure;
  Vec<Dim, Real> velocity;

  template <class Visit>
  static constexpr void forEachMember(Visit&& visit) {
    visit(FieldTag<FieldId::mass>{}, &ParticleView::mass);
    visit(FieldTag<FieldId::density>{}, &ParticleView::density);
    visit(FieldTag<FieldId::pressure>{}, &ParticleView::pressure);
    visit(FieldTag<FieldId::velocity>{}, &ParticleView::velocity);
  }
};

/// The fields of particle i that terms may add to.
template <class Real, int Dim>
struct Sums {
  Real density{};
  Real densityRate{};
  Vec<Dim, Real> acceleration{};
  Vec<Dim, Real> velocityChange{};

  template <class Visit>
  static constexpr void forEachMember(Visit&& visit) {
    visit(FieldTag<FieldId::density>{}, &Sums::density);
    visit(FieldTag<FieldId::densityRate>{}, &Sums::densityRate);
    visit(FieldTag<FieldId::acceleration>{}, &Sums::acceleration);
    visit(FieldTag<FieldId::velocityChange>{}, &Sums::velocityChange);
  }
};

/// A pair of neighbours. W [m^-d] and F [m^-(d+2)] are the kernel and its gradient's factor:
/// grad_i W_ij = F r_ij.
template <class Real, int Dim>
struct Pair {
  ParticleView<Real, Dim> i, j;
  Vec<Dim, Real> r;      ///< r_ij = r_i - r_j, nearest periodic image [m]
  Real distanceSquared;  ///< |r_ij|^2 [m^2]
  Real h;                ///< smoothing length [m]
  Real W;
  Real F;

  /// v_ij . r_ij [m^2/s]; negative for approaching particles.
  Real velocityDotR() const { return dot(i.velocity - j.velocity, r); }
  /// v_ij . grad_i W_ij [m^-d s^-1]
  Real velocityDotGradW() const { return F * velocityDotR(); }
  /// grad_i W_ij [m^-(d+1)]
  Vec<Dim, Real> gradW() const { return F * r; }
};

}  // namespace plenum
