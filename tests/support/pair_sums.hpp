// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an engine's sums are compared with: every particle against every other one, in long double.
#pragma once

#include "engine/engine.hpp"
#include "engine/layout.hpp"
#include "engine/pair_loop.hpp"
#include "engine/pass_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace plenum::test {

/// Mass around a particle and its gradient.
struct GradientProbe {
  static constexpr FieldSet reads{field::mass};
  static constexpr FieldSet writes{field::density, field::acceleration};
  static constexpr bool usesKernel = true;

  template <class Real, int Dim>
  void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.density += ij.j.mass * ij.W;
    i.acceleration += ij.j.mass * ij.gradW();
  }
};

/// Sums of all components that a pass writes, one row a particle, and the sizes of what was added.
struct PairSums {
  int nOut = 0;
  std::vector<long double> value, size;  ///< [particle][component]; size: sum of |pair term|

  /// Root mean square of `size` over the particles in [first, last): what a sum is accurate to is
  /// a small part of this.
  double typicalSize(int component, std::size_t first, std::size_t last) const {
    long double squares = 0;
    for (std::size_t i = first; i < last; ++i) {
      const long double s =
          size[i * static_cast<std::size_t>(nOut) + static_cast<std::size_t>(component)];
      squares += s * s;
    }
    return static_cast<double>(std::sqrt(squares / static_cast<long double>(last - first)));
  }
};

template <int Dim>
Vec<Dim, long double> toLong(const Vec<Dim>& x) {
  Vec<Dim, long double> y;
  for (int a = 0; a < Dim; ++a) y[a] = x[a];
  return y;
}

template <int Dim>
ParticleView<long double, Dim> viewOf(const ParticleSet<Dim>& particles, std::size_t i) {
  ParticleView<long double, Dim> view;
  view.velocity = toLong(particles[field::velocity][i]);
  view.mass = particles[field::mass][i];
  view.density = particles[field::density][i];
  view.pressure = particles[field::pressure][i];
  view.smoothingLength =
      particles.has(field::smoothingLength) ? particles[field::smoothingLength][i] : 0;
  view.volume = view.mass / view.density;
  view.specificVolume = 1 / view.density;
  view.pressureOverDensitySquared = view.pressure / (view.density * view.density);
  if (particles.has(field::dynamicViscosity))
    view.dynamicViscosity = particles[field::dynamicViscosity][i];
  if (particles.has(field::soundSpeed)) view.soundSpeed = particles[field::soundSpeed][i];
  if (particles.has(field::internalEnergy))
    view.internalEnergy = particles[field::internalEnergy][i];
  if (particles.has(field::viscosityLimiter))
    view.viscosityLimiter = particles[field::viscosityLimiter][i];
  if (particles.has(field::densityGradient))
    view.densityGradient = toLong(particles[field::densityGradient][i]);
  return view;
}

/// The nearest image of x_i - x_j.
template <int Dim>
Vec<Dim, long double> difference(const Box<Dim>& box, const Vec<Dim>& xi, const Vec<Dim>& xj) {
  Vec<Dim, long double> r = toLong(xi) - toLong(xj);
  for (int a = 0; a < Dim; ++a) {
    if (!box.isPeriodic(a)) continue;
    const long double period = static_cast<long double>(box.upper[a]) - box.lower[a];
    r[a] -= period * std::nearbyint(r[a] / period);
  }
  return r;
}

inline bool isIn(Group group, std::size_t particle, std::size_t nFluid) {
  return particle < nFluid ? hasFluids(group) : hasWalls(group);
}

/// The double loop. Walls and fluids outside of `receivers` keep zero.
template <int Dim, class Profile, class... Terms>
PairSums sumOfAllPairs(const Pass<Profile, Terms...>& pass, const ParticleSet<Dim>& particles,
                       const Box<Dim>& box, Group receivers, Group sources) {
  using Real = long double;
  constexpr FieldSet writes = Pass<Profile, Terms...>::writes;
  PairSums sums;
  sums.nOut = componentsOf<Dim>(writes);
  const auto nOut = static_cast<std::size_t>(sums.nOut);
  sums.value.assign(particles.size() * nOut, 0);
  sums.size.assign(particles.size() * nOut, 0);
  const Real sigma = sigmaOf<Dim>(pass.profile);
  const auto kernel = [&](Real distance, Real h) {
    const Real factor = sigma * power<Dim>(1 / h);
    return KernelValues<Real>{factor * pass.profile.f(distance / h),
                              factor / (h * h) * pass.profile.g(distance / h)};
  };
  std::vector<ParticleView<Real, Dim>> views;
  for (std::size_t i = 0; i < particles.size(); ++i) views.push_back(viewOf(particles, i));
  const auto x = particles[field::position];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!isIn(receivers, i, particles.nFluid())) continue;
    for (std::size_t j = 0; j < particles.size(); ++j) {
      if (!isIn(sources, j, particles.nFluid())) continue;
      const Vec<Dim, Real> r = difference(box, x[i], x[j]);
      const Real distanceSquared = normSquared(r);
      Real hi = pass.smoothingLength, hj = pass.smoothingLength;
      if constexpr (isAdaptive<Profile>) {
        hi = views[i].smoothingLength;
        hj = views[j].smoothingLength;
      }
      const Real h = (hi + hj) / 2, larger = std::max(hi, hj);
      if (distanceSquared > 4 * larger * larger) continue;
      const Real distance = std::sqrt(distanceSquared);
      const KernelValues<Real> ofI = kernel(distance, hi), ofJ = kernel(distance, hj);
      const Real F = (ofI.F + ofJ.F) / 2;
      const Pair<Real, Dim> ij{views[i],
                               views[j],
                               r,
                               distanceSquared,
                               dot(views[i].velocity - views[j].velocity, r),
                               h,
                               (ofI.W + ofJ.W) / 2,
                               F,
                               ofI,
                               ofJ};
      Sums<Real, Dim> toI;
      Exchange<Real, Dim> exchange;
      const auto evaluate = [&](const auto& term) {
        using Term = std::remove_cvref_t<decltype(term)>;
        if constexpr (Exchanges<Term, Real, Dim>)
          term(ij, exchange);
        else if constexpr (ExchangesAndGives<Term, Real, Dim>)
          term(ij, exchange, toI);
        else
          term(ij, toI);
      };
      std::apply([&](const auto&... term) { (evaluate(term), ...); }, pass.terms);
      const auto add = [&](int component, Real value) {
        const std::size_t k = i * nOut + static_cast<std::size_t>(component);
        sums.value[k] += value;
        sums.size[k] += std::abs(value);
      };
      const auto addAll = [&]<class S>(const S& pair) {
        S::forEachMember([&](auto tag, auto member) {
          if constexpr (writes.has(tag)) {
            constexpr int first = offsetOf<Dim>(writes, tag);
            if constexpr (infoOf(tag).rank == Rank::vector) {
              const Vec<Dim, Real> total = (pair.*member).total(F, r);
              for (int a = 0; a < Dim; ++a) add(first + a, total[a]);
            } else {
              add(first, pair.*member);
            }
          }
        });
      };
      addAll(toI);
      addAll(exchange);
    }
  }
  return sums;
}

/// What a deviation is measured by: the typical size of the component's sums, or, where sizes of
/// particles differ by orders of magnitude, that of the particle's own sum if it is larger.
enum class Measure { typical, own };

/// Largest deviation of the engine's last sums from the double loop, over the receivers. Infinite
/// if some sum is not finite.
template <int Dim>
double worstDeviation(const Engine<Dim>& engine, FieldSet writes, const ParticleSet<Dim>& particles,
                      const PairSums& expected, Group receivers,
                      Measure measure = Measure::typical) {
  const std::size_t nFluid = particles.nFluid();
  const std::size_t first = hasFluids(receivers) ? 0 : nFluid;
  const std::size_t last = hasWalls(receivers) ? particles.size() : nFluid;
  if (first == last) return 0;
  double worst = 0;
  const auto compare = [&](int component, std::size_t i, double sum) {
    const std::size_t k =
        i * static_cast<std::size_t>(expected.nOut) + static_cast<std::size_t>(component);
    const long double value = expected.value[k];
    double typical = expected.typicalSize(component, first, last);
    if (measure == Measure::own) typical = std::max(typical, static_cast<double>(expected.size[k]));
    if (!std::isfinite(sum)) worst = std::numeric_limits<double>::infinity();
    if (typical > 0)
      worst = std::max(worst, std::abs(static_cast<double>(sum - value)) / typical);
    else if (sum != 0)
      worst = std::numeric_limits<double>::infinity();
  };
  const auto compareField = [&](auto tag, auto) {
    constexpr FieldInfo info = infoOf(tag);
    if (!writes.has(tag)) return;
    const int offset = offsetOf<Dim>(writes, tag);
    const auto sums = engine.sums(Field<info.rank>{info.id});
    for (std::size_t i = first; i < last; ++i) {
      if constexpr (info.rank == Rank::vector)
        for (int a = 0; a < Dim; ++a) compare(offset + a, i, sums[i][a]);
      else
        compare(offset, i, sums[i]);
    }
  };
  Sums<double, Dim>::forEachMember(compareField);
  Exchange<double, Dim>::forEachMember(compareField);
  return worst;
}

/// What sums are accurate to, in units of the typical sum of |pair terms|. Double: some 100
/// additions of 1.1e-16 each. Mixed: positions relative to clusters and sums in float, 6e-8 each;
/// kernels that are steep at r = 0 multiply the error of the closest pairs.
constexpr double toleranceOf(Precision precision) {
  return precision == Precision::mixed ? 1e-5 : 1e-13;
}

/// How wrong an engine's sums of GradientProbe are, for fluids from all.
template <int Dim>
double deviationOf(Engine<Dim>& engine, const ParticleSet<Dim>& particles, const Box<Dim>& box) {
  const Pass<kernel::WendlandC2, GradientProbe> pass{{}, 0.5 * engine.support(), {}};
  engine.run(passOf<Dim>(pass), particles);
  return worstDeviation(engine, pass.writes, particles,
                        sumOfAllPairs<Dim>(pass, particles, box, Group::fluids, Group::all),
                        Group::fluids);
}

inline const char* nameOf(Precision precision) {
  return precision == Precision::mixed ? "mixed" : "double";
}

inline constexpr Precision bothPrecisions[] = {Precision::mixed, Precision::doubled};
inline constexpr Group allGroups[] = {Group::all, Group::fluids, Group::walls};

}  // namespace plenum::test
