// SPDX-License-Identifier: GPL-3.0-or-later
//
// Packs of pairs against the same pairs one by one.
#pragma once

#include "engine/instruction_set.hpp"
#include "engine/pack.hpp"
#include "engine/pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace plenum::test {

/// Of a number: `relative` times its size and that of summands which may cancel in it.
struct Tolerance {
  double relative = 0;
  double summands = 0;

  double of(double value) const { return relative * (std::abs(value) + summands); }
};

/// A pack of pairs gives in each lane what the pair of that lane gives.
template <class T, int N>
class Lanes {
  using P = Pack<T, N, isa::Baseline>;

 public:
  template <class Term>
  static void expectSame(const Term& term, const Tolerance& tolerance) {
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<T> uniform(-1, 1);
    const auto anyNumber = [&] { return uniform(generator); };
    for (int trial = 0; trial < 100; ++trial) {
      ParticleView<T, 3> is[N], js[N];
      Vec<3, T> rs[N];
      ParticleView<P, 3> i, j;
      Vec<3, P> r;
      T W[N], F[N];
      P packW, packF;
      for (int k = 0; k < N; ++k) {
        for (auto* view : {&is[k], &js[k]}) {
          ParticleView<T, 3>::forEachMember([&](auto tag, auto member) {
            if constexpr (infoOf(tag).rank == Rank::vector)
              for (int a = 0; a < 3; ++a) (view->*member)[a] = anyNumber();
            else
              view->*member = 2 + anyNumber();
          });
        }
        for (int a = 0; a < 3; ++a) rs[k][a] = T(0.2) * anyNumber();
        W[k] = 2 + anyNumber();
        F[k] = anyNumber() - 2;
        setLane(i, is[k], k);
        setLane(j, js[k], k);
        for (int a = 0; a < 3; ++a) r[a].raw[k] = rs[k][a];
        packW.raw[k] = W[k];
        packF.raw[k] = F[k];
      }
      const Pair<P, 3> packs{i,       j,     r,     normSquared(r), dot(i.velocity - j.velocity, r),
                             P(0.3f), packW, packF, {packW, packF}, {packW, packF}};
      for (int k = 0; k < N; ++k) {
        const Pair<T, 3> one{
            is[k],   js[k], rs[k], normSquared(rs[k]), dot(is[k].velocity - js[k].velocity, rs[k]),
            T(0.3f), W[k],  F[k],  {W[k], F[k]},       {W[k], F[k]}};
        if constexpr (Exchanges<Term, P, 3>)
          compare([&](const auto& pair, auto& exchange, auto&) { term(pair, exchange); }, packs,
                  one, k, tolerance);
        else if constexpr (ExchangesAndGives<Term, P, 3>)
          compare(term, packs, one, k, tolerance);
        else
          compare([&](const auto& pair, auto&, auto& sums) { term(pair, sums); }, packs, one, k,
                  tolerance);
      }
    }
  }

 private:
  template <class Term>
  static void compare(const Term& term, const Pair<P, 3>& packs, const Pair<T, 3>& one, int k,
                      const Tolerance& tolerance) {
    Exchange<P, 3> exchange;
    Exchange<T, 3> expectedExchange;
    Sums<P, 3> sums;
    Sums<T, 3> expectedSums;
    term(packs, exchange, sums);
    term(one, expectedExchange, expectedSums);
    expectSameMembers(exchange, expectedExchange, k, tolerance);
    expectSameMembers(sums, expectedSums, k, tolerance);
  }
  template <class OfPacks, class OfOne>
  static void expectSameMembers(const OfPacks& sums, const OfOne& expected, int k,
                                const Tolerance& tolerance) {
    OfPacks::forEachMember([&](auto tag, auto member) {
      OfOne::forEachMember([&](auto other, auto expectedMember) {
        if constexpr (tag() == other())
          expectSame(sums.*member, expected.*expectedMember, k, tolerance);
      });
    });
  }
  static void setLane(ParticleView<P, 3>& pack, const ParticleView<T, 3>& one, int k) {
    ParticleView<P, 3>::forEachMember([&](auto tag, auto member) {
      ParticleView<T, 3>::forEachMember([&](auto other, auto from) {
        if constexpr (tag() != other())
          return;
        else if constexpr (infoOf(tag).rank == Rank::vector)
          for (int a = 0; a < 3; ++a) (pack.*member)[a].raw[k] = (one.*from)[a];
        else
          (pack.*member).raw[k] = one.*from;
      });
    });
  }
  static void expectSame(const P& pack, T one, int k, const Tolerance& tolerance) {
    EXPECT_NEAR(pack.raw[k], one, tolerance.of(one));
  }
  static void expectSame(const VectorSum<P, 3>& pack, const VectorSum<T, 3>& one, int k,
                         const Tolerance& tolerance) {
    expectSame(pack.alongGradW, one.alongGradW, k, tolerance);
    expectSame(pack.alongR, one.alongR, k, tolerance);
    for (int a = 0; a < 3; ++a) expectSame(pack.rest[a], one.rest[a], k, tolerance);
  }
};

template <class Term>
void expectLanesAreSingles(const Term& term, double summands = 0) {
  // A dozen roundings of each, in another order: the loop's flags let the compiler choose it.
  Lanes<double, 2>::expectSame(term, {2e-15, summands});
  Lanes<double, 4>::expectSame(term, {2e-15, summands});
  Lanes<double, 8>::expectSame(term, {2e-15, summands});
  Lanes<float, 2>::expectSame(term, {2e-6, summands});
  Lanes<float, 4>::expectSame(term, {2e-6, summands});
  Lanes<float, 8>::expectSame(term, {2e-6, summands});
}

}  // namespace plenum::test
