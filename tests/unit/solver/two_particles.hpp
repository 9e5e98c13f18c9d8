// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two particles, for terms written out by hand.
#pragma once

#include "particles/kernels.hpp"
#include "solver/terms.hpp"

#include <utility>

namespace plenum::test {

using K = Kernel<2, kernel::CubicSpline>;
inline constexpr double h = 0.3;
inline constexpr double ulp = 1e-15;  // relative: a few roundings

inline ParticleView<double, 2> particle(double mass, double density, double pressure,
                                        const Vec<2>& velocity) {
  ParticleView<double, 2> view{};
  view.velocity = velocity;
  view.mass = mass;
  view.density = density;
  view.pressure = pressure;
  view.smoothingLength = h;
  view.volume = mass / density;
  view.specificVolume = 1 / density;
  view.pressureOverDensitySquared = pressure / (density * density);
  return view;
}

/// Two particles and what the loop computes for them.
struct Two {
  ParticleView<double, 2> i = particle(2.0, 1.1, 5.0, {{1.0, 0.5}});
  ParticleView<double, 2> j = particle(3.0, 0.9, -2.0, {{-1.0, 0.25}});
  Vec<2> r{{-0.2, 0.1}};

  double W() const { return K::W(norm(r), h); }
  double F() const { return K::F(norm(r), h); }
  double velocityDotR() const { return dot(i.velocity - j.velocity, r); }
  Pair<double, 2> pair() const {
    return {i, j, r, normSquared(r), velocityDotR(), h, W(), F(), {W(), F()}, {W(), F()}};
  }
};

inline Two approaching() { return {}; }

inline Two receding() {
  Two two;
  std::swap(two.i.velocity, two.j.velocity);
  return two;
}

template <class Term>
Sums<double, 2> sumsOf(const Term& term, const Two& two) {
  Sums<double, 2> sums;
  term(two.pair(), sums);
  return sums;
}

template <class Term>
Exchange<double, 2> exchangeOf(const Term& term, const Two& two) {
  Exchange<double, 2> exchange;
  term(two.pair(), exchange);
  return exchange;
}

/// What particle i gets a unit of mass.
template <class Term>
Vec<2> accelerationOf(const Term& term, const Two& two) {
  return 1 / two.i.mass * exchangeOf(term, two).force.total(two.F(), two.r);
}

inline Vec<2> velocityChangeOf(const term::Collision& collision, const Two& two) {
  return 1 / two.i.mass * exchangeOf(collision, two).impulse.total(two.F(), two.r);
}

}  // namespace plenum::test
