// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which terms share a loop. A new term is one more base of `AllTerms` and one more line, or a
// longer one, in `forEachTermList`.
#pragma once

#include "engine/loop_profile.hpp"
#include "engine/tile_work.hpp"
#include "solver/terms.hpp"

namespace plenum {

/// Every term with its parameters; those that a pass does not have are unused.
struct AllTerms : term::DensitySum,
                  term::Continuity,
                  term::PressureDensitySquared,
                  term::PressureDensityProduct,
                  term::MonaghanViscosity,
                  term::Collision {};

template <class... Terms>
struct TermList {
  static constexpr FieldSet reads = (FieldSet{} | ... | Terms::reads);
  static constexpr FieldSet writes = (FieldSet{} | ... | Terms::writes);
  static constexpr bool usesKernel = (Terms::usesKernel || ...);
};

/// The lists of terms that have a loop of their own.
template <class Visit>
constexpr void forEachTermList(Visit&& visit) {
  using namespace term;
  visit(TermList<DensitySum>{});
  visit(TermList<Continuity>{});
  visit(TermList<PressureDensitySquared>{});
  visit(TermList<PressureDensitySquared, MonaghanViscosity>{});
  visit(TermList<PressureDensityProduct>{});
  visit(TermList<PressureDensityProduct, MonaghanViscosity>{});
  visit(TermList<Collision>{});
}

/// Place of a list in `forEachTermList`.
template <class List>
constexpr int indexOf() {
  int index = -1, k = 0;
  forEachTermList([&](auto list) {
    if (std::is_same_v<decltype(list), List>) index = k;
    ++k;
  });
  return index;
}

/// Calls `visit` with the profile that the loops for a kernel have: the kernels that scenes name
/// have loops of their own in 2-D and 3-D, the others share those of kernel::Any.
template <int Dim, bool usesKernel, class Visit>
constexpr void withLoopProfile(int id, Visit&& visit) {
  if constexpr (!usesKernel)
    visit(NoKernel{});
  else if constexpr (Dim == 1)
    visit(kernel::Any{});
  else
    withProfileAmong<kernel::CubicSpline, kernel::WendlandC2, kernel::WendlandC2OneD,
                     kernel::WendlandQuadratic, kernel::Convex>(id, visit);
}

/// What a loop was chosen for.
struct PassChoice {
  int kernel = 0;    ///< place in kernel::forEachProfile
  int termList = 0;  ///< place in forEachTermList
  double smoothingLength = 0;
  AllTerms terms;
};

/// The loop for a choice, compiled for the instruction set `Isa` (pair_loops.cpp).
template <class Isa, class T, int Dim>
TileFunction<Dim, T> tileFunction(const PassChoice& choice);

}  // namespace plenum
