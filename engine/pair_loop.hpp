// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one loop over neighbours. A pass names a kernel and the terms that share the loop; what the
// terms read is loaded, what they write is stored, the rest costs nothing.
#pragma once

#include "engine/engine.hpp"
#include "engine/pair.hpp"
#include "particles/kernels.hpp"

#include <array>
#include <cassert>
#include <tuple>

namespace plenum {

/// One loop over all pairs. `Profile` is a kernel of particles/kernels.hpp or kernel::Any.
template <class Profile, class... Terms>
struct Pass {
  static constexpr FieldSet reads = (FieldSet{} | ... | Terms::reads);
  static constexpr FieldSet writes = (FieldSet{} | ... | Terms::writes);

  Profile profile;
  double smoothingLength;  ///< h of all particles [m]
  std::tuple<Terms...> terms;
  Group receivers = Group::fluids;
  Group sources = Group::all;
};

namespace pair_loop {

/// Pointers to the arrays that a pass reads or writes; the others are null.
template <int Dim>
struct Arrays {
  template <FieldId Id>
  using Value = ValueOf<infoOf(Id).rank, Dim>;

  std::array<void*, nFields> data{};

  explicit Arrays(ParticleSet<Dim>& particles) {
    particles.forEachField([&](const FieldInfo& info, auto values) {
      data[static_cast<std::size_t>(info.id)] = values.data();
    });
  }

  template <FieldId Id>
  Value<Id>* get(FieldTag<Id>) const {
    return static_cast<Value<Id>*>(data[static_cast<std::size_t>(Id)]);
  }
};

template <class Pass, int Dim>
inline ParticleView<double, Dim> load(const Arrays<Dim>& arrays, std::size_t k) {
  ParticleView<double, Dim> view;
  ParticleView<double, Dim>::forEachMember([&](auto tag, auto member) {
    if constexpr (Pass::reads.has(tag)) view.*member = arrays.get(tag)[k];
  });
  return view;
}

template <class Pass, int Dim>
inline void store(const Arrays<Dim>& arrays, std::size_t k, const Sums<double, Dim>& sums) {
  Sums<double, Dim>::forEachMember([&](auto tag, auto member) {
    if constexpr (Pass::writes.has(tag)) arrays.get(tag)[k] = sums.*member;
  });
}

/// sigma of a profile that is known at compile time or chosen at run time.
template <int Dim, class Profile>
double sigmaOf(const Profile& profile) {
  if constexpr (requires { profile.sigma(Dim); })
    return profile.sigma(Dim);
  else
    return Profile::sigma[Dim - 1];
}

/// The sums of one particle over the given neighbours.
template <int Dim, class Profile, class... Terms>
inline void sumOver(const Pass<Profile, Terms...>& pass, const Arrays<Dim>& arrays,
                    const Periodicity<Dim>& periodicity, std::size_t i,
                    std::span<const std::uint32_t> neighbours) {
  using ThisPass = Pass<Profile, Terms...>;
  const double h = pass.smoothingLength, inverseH = 1 / h;
  const double sigmaW = sigmaOf<Dim>(pass.profile) * power<Dim>(inverseH);
  const double sigmaF = sigmaW * inverseH * inverseH;
  const double supportSquared = 4 * h * h;
  const Vec<Dim>* positions = arrays.get(FieldTag<FieldId::position>{});
  const Vec<Dim> x = positions[i];

  Pair<double, Dim> ij;
  ij.i = load<ThisPass>(arrays, i);
  ij.h = h;
  Sums<double, Dim> sums;
  const auto add = [&](std::uint32_t j) {
    ij.r = periodicity.nearestImage(x - positions[j]);
    ij.distanceSquared = normSquared(ij.r);
    const double R = squareRoot(ij.distanceSquared) * inverseH;
    ij.W = sigmaW * pass.profile.f(R);
    ij.F = sigmaF * pass.profile.g(R);
    ij.j = load<ThisPass>(arrays, j);
    std::apply([&](const auto&... terms) { (terms(ij, sums), ...); }, pass.terms);
  };
  // The list holds its skin, too. First those in the support are picked without a branch, then
  // summed.
  constexpr std::size_t batch = 128;
  std::array<std::uint32_t, batch> near;
  for (std::size_t first = 0; first < neighbours.size(); first += batch) {
    std::size_t nNear = 0;
    for (const std::uint32_t j :
         neighbours.subspan(first, std::min(batch, neighbours.size() - first))) {
      near[nNear] = j;
      nNear += normSquared(periodicity.nearestImage(x - positions[j])) < supportSquared;
    }
    for (std::size_t k = 0; k < nNear; ++k) add(near[k]);
  }
  const auto addSelf = [&](const auto& term) {
    if constexpr (requires { term.self(ij.i, sigmaW, sums); })
      term.self(ij.i, sigmaW * pass.profile.f(0.0), sums);
  };
  std::apply([&](const auto&... terms) { (addSelf(terms), ...); }, pass.terms);
  store<ThisPass>(arrays, i, sums);
}

}  // namespace pair_loop

/// Walls carry only some of the fields that fluids have; a pass over walls may write those alone.
constexpr bool wallsCarry(FieldSet fields) {
  for (const FieldInfo& info : fieldTable)
    if (fields.has(info.id) && info.scope == Scope::fluid) return false;
  return true;
}

/// Overwrites the fields that the pass writes, for all its receivers. Each particle sums over its
/// own neighbours in list order, so the result does not depend on the number of threads.
/// `engine.update` must have been called for these positions.
template <int Dim, class Profile, class... Terms>
void runPass(const Pass<Profile, Terms...>& pass, const Engine<Dim>& engine,
             ParticleSet<Dim>& particles) {
  const pair_loop::Arrays<Dim> arrays(particles);
  const NeighbourList<Dim>& list = engine.neighbours();
  assert(pass.receivers == Group::fluids || wallsCarry(pass.writes));
  assert(pass.receivers == Group::fluids || list.nReceivers() == particles.size());
  const auto blocks = list.blocks();
  const std::size_t first = pass.receivers == Group::walls ? particles.nFluid() : 0;
  const std::size_t last = pass.receivers == Group::fluids ? particles.nFluid() : particles.size();

#pragma omp parallel for schedule(dynamic, 1)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks.size()); ++b) {
    const auto& block = blocks[static_cast<std::size_t>(b)];
    const std::size_t end = std::min(block.last, last);
    for (std::size_t i = std::max(block.first, first); i < end; ++i) {
      const auto neighbours = pass.sources == Group::fluids  ? list.fluidsOf(block, i)
                              : pass.sources == Group::walls ? list.wallsOf(block, i)
                                                             : list.allOf(block, i);
      pair_loop::sumOver<Dim>(pass, arrays, engine.periodicity(), i, neighbours);
    }
  }
}

}  // namespace plenum
