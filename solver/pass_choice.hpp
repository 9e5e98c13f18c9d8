// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which terms share a loop. A new term is one more of `AllTerms` and one more line, or a
// longer one, in `forEachTermList`.
#pragma once

#include "engine/loop_profile.hpp"
#include "engine/pair_loop.hpp"
#include "engine/tile_work.hpp"
#include "solver/gas_terms.hpp"
#include "solver/pair_pass.hpp"
#include "solver/terms.hpp"

namespace plenum {

/// Every term with its parameters; those that a pass does not have are unused.
using AllTerms =
    std::tuple<term::DensitySum, term::Continuity, term::DensityGradient, term::DensityDiffusion,
               term::PressureDensitySquared, term::PressureDensityProduct, term::MonaghanViscosity,
               term::MonaghanViscosityOfPhases, term::LaminarViscosity,
               term::LaminarViscosityOfPhases, term::FluidAtWall, term::VelocityAtWall,
               term::Concentration, term::Collision, term::OmegaDensity, term::DensityMoment,
               term::DensityRate, term::VelocityCurl, term::PressureGradH, term::PressureWork,
               term::HeatingViscosity, term::BalsaraViscosity, term::Conductivity>;

template <class... Terms>
struct TermList {
  static constexpr FieldSet reads = (FieldSet{} | ... | Terms::reads);
  static constexpr FieldSet writes = (FieldSet{} | ... | Terms::writes);
  static constexpr bool usesKernel = (Terms::usesKernel || ...);

  template <class Profile>
  using ProfileOf = Profile;
};

/// The same for particles that have a smoothing length each.
template <class... Terms>
struct OwnLengths {
  static constexpr FieldSet reads = TermList<Terms...>::reads | FieldSet{field::smoothingLength};
  static constexpr FieldSet writes = TermList<Terms...>::writes;
  static constexpr bool usesKernel = true;

  template <class Profile>
  using ProfileOf = Adaptive<Profile>;
};

/// The lists of terms that have a loop of their own. visit(list, isTuned): the first ones, where
/// most scenes spend most of their time, have one for each kernel that scenes name.
template <class Visit>
constexpr void forEachTermList(Visit&& visit) {
  using namespace term;
  constexpr std::true_type tuned;
  constexpr std::false_type generic;
  visit(TermList<DensitySum>{}, tuned);
  visit(TermList<Continuity>{}, tuned);
  visit(TermList<PressureDensitySquared, MonaghanViscosity>{}, tuned);
  visit(TermList<PressureDensityProduct, MonaghanViscosity>{}, tuned);
  const auto visitForces = [&]<class Pressure>(Pressure) {
    visit(TermList<Pressure>{}, generic);
    visit(TermList<Pressure, MonaghanViscosityOfPhases>{}, generic);
    visit(TermList<Pressure, LaminarViscosity>{}, generic);
    visit(TermList<Pressure, MonaghanViscosityOfPhases, LaminarViscosityOfPhases>{}, generic);
  };
  visitForces(PressureDensitySquared{});
  visitForces(PressureDensityProduct{});
  visit(TermList<DensityGradient>{}, generic);
  visit(TermList<Continuity, DensityDiffusion>{}, generic);
  visit(TermList<FluidAtWall>{}, generic);
  visit(TermList<FluidAtWall, VelocityAtWall>{}, generic);
  visit(OwnLengths<DensitySum, OmegaDensity>{}, tuned);
  visit(OwnLengths<DensityMoment>{}, generic);
  visit(OwnLengths<DensityRate, VelocityCurl>{}, generic);
  visit(OwnLengths<PressureDensitySquared, MonaghanViscosityOfPhases, DensityRate>{}, generic);
  visit(OwnLengths<PressureGradH, MonaghanViscosityOfPhases, DensityRate>{}, generic);
  visit(OwnLengths<PressureGradH, HeatingViscosity, DensityRate>{}, tuned);
  visit(OwnLengths<PressureGradH, BalsaraViscosity, DensityRate>{}, generic);
  visit(OwnLengths<PressureGradH, BalsaraViscosity, Conductivity, DensityRate>{}, generic);
  visit(OwnLengths<PressureDensitySquared, BalsaraViscosity, DensityRate>{}, generic);
  visit(OwnLengths<PressureDensitySquared, PressureWork, BalsaraViscosity, Conductivity,
                   DensityRate>{},
        generic);
  visit(TermList<Concentration>{}, generic);
  visit(TermList<Collision>{}, generic);
}

/// Place of a list in `forEachTermList`.
template <class List>
constexpr int indexOf() {
  int index = -1, k = 0;
  forEachTermList([&](auto list, auto) {
    if (std::is_same_v<decltype(list), List>) index = k;
    ++k;
  });
  return index;
}

/// Calls `visit` with the profile that the loops for a kernel have: in float tuned ones for the
/// kernels that scenes name, or for the default kernel only; the others, and double, where speed
/// matters less, share those of kernel::Any, which take about a third more time.
template <int Dim, class T, bool usesKernel, bool isTuned, class Visit>
constexpr void withLoopProfile(int id, Visit&& visit) {
  if constexpr (!usesKernel)
    visit(NoKernel{});
  else if constexpr (Dim == 1 || std::is_same_v<T, double>)
    visit(kernel::Any{});
  else if constexpr (isTuned)
    withProfileAmong<kernel::WendlandC2, kernel::WendlandC2OneD, kernel::Convex>(id, visit);
  else
    withProfileAmong<kernel::WendlandC2>(id, visit);
}

/// What a loop was chosen for.
struct PassChoice {
  int kernel = 0;    ///< place in kernel::forEachProfile
  int termList = 0;  ///< place in forEachTermList
  double smoothingLength = 0;
  AllTerms terms;
};

/// The loop for a choice, compiled for the instruction set `Isa` (pair_loops.cpp); null where there
/// are none.
template <class Isa, class T, int Dim>
TileFunction<Dim, T> tileFunction(const PassChoice& choice);

}  // namespace plenum
