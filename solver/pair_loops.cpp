// SPDX-License-Identifier: GPL-3.0-or-later
//
// Run-time choices become template arguments here and nowhere else. This source is compiled once
// for each instruction set and precision: PLENUM_ISA and PLENUM_REAL.
#include "engine/instruction_set.hpp"
#include "solver/pass_choice.hpp"

#include <algorithm>

namespace plenum {

namespace {

/// Builds the pass from the choice and sums it.
template <class Real, int Dim, class Profile, class... Terms>
void sumChosen(const TileWork<Dim, typename Real::Scalar>& work, const void* chosen) {
  const auto& choice = *static_cast<const PassChoice*>(chosen);
  const Pass<Profile, Terms...> pass{profileOf<Profile>(choice.kernel),
                                     choice.smoothingLength,
                                     {std::get<Terms>(choice.terms)...}};
  TileLoop<Real, Dim, Profile, Terms...>(work, pass).run();
}

}  // namespace

template <class Isa, class T, int Dim>
TileFunction<Dim, T> tileFunction(const PassChoice& choice) {
  using Real = Pack<T, std::min<int>(Isa::bytes / sizeof(T), clusterSize), Isa>;
  TileFunction<Dim, T> function = nullptr;
  int k = 0;
  forEachTermList([&]<template <class...> class List, class... Terms, bool isTuned>(
                      List<Terms...> list, std::bool_constant<isTuned>) {
    if (k++ != choice.termList) return;
    if constexpr (hasLoops<Dim, T>)
      withLoopProfile<Dim, T, list.usesKernel, isTuned>(choice.kernel, [&]<class Profile>(Profile) {
        using Own = typename List<Terms...>::template ProfileOf<Profile>;
        function = &sumChosen<Real, Dim, Own, Terms...>;
      });
  });
  return function;
}

using Isa = isa::PLENUM_ISA;
template TileFunction<1, PLENUM_REAL> tileFunction<Isa, PLENUM_REAL, 1>(const PassChoice&);
template TileFunction<2, PLENUM_REAL> tileFunction<Isa, PLENUM_REAL, 2>(const PassChoice&);
template TileFunction<3, PLENUM_REAL> tileFunction<Isa, PLENUM_REAL, 3>(const PassChoice&);

}  // namespace plenum
