// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/interactions.hpp"

#include "engine/pass_of.hpp"
#include "solver/pass_choice.hpp"

namespace plenum {

namespace {

/// 1 for each neighbour, the particle itself included.
struct NeighbourCount {
  static constexpr FieldSet reads{field::mass};
  static constexpr FieldSet writes{field::density};
  static constexpr bool usesKernel = false;

  double support = 0;  ///< [m]

  NeighbourCount inUnits(const Units& units) const { return {support / units.length}; }

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    i.density += select(ij.distanceSquared < Real(support * support), Real(1), Real(0));
  }
};

/// The same within twice the smoothing length of the receiver.
struct NeighbourCountOfLengths {
  static constexpr FieldSet reads{field::mass, field::smoothingLength};
  static constexpr FieldSet writes{field::density};
  static constexpr bool usesKernel = false;

  template <class Real, int Dim>
  [[gnu::always_inline]] void operator()(const Pair<Real, Dim>& ij, Sums<Real, Dim>& i) const {
    const Real support = Real(2) * ij.i.smoothingLength;
    i.density += select(ij.distanceSquared < support * support, Real(1), Real(0));
  }
};

template <int Dim, class Term>
Interactions sumOf(Engine<Dim>& engine, const ParticleSet<Dim>& particles, bool wallsReceive,
                   const Term& term) {
  const Pass<NoKernel, Term> pass{{}, engine.support() / 2, {term}};
  engine.run(
      passOf<Dim>(pass, wallsReceive ? Group::all : Group::fluids, Group::all, engine.units()),
      particles);
  const double one = engine.units().of(field::density.id, Dim);  // sums come in SI
  Interactions count;
  engine.withSums(field::density, [&](const auto& sums) {
    for (std::size_t c = 0; c < sums.nClusters(wallsReceive); ++c)
      sums.forEach(c, [&](std::size_t i, double sum) {
        const double others = sum / one - 1;
        count.all += others;
        if (i < particles.nFluid()) count.ofFluids += others;
      });
  });
  return count;
}

}  // namespace

template <int Dim>
Interactions countInteractions(Engine<Dim>& engine, const ParticleSet<Dim>& particles,
                               bool wallsReceive) {
  if (particles.has(field::smoothingLength))
    return sumOf(engine, particles, wallsReceive, NeighbourCountOfLengths{});
  return sumOf(engine, particles, wallsReceive, NeighbourCount{engine.support()});
}

template Interactions countInteractions<1>(Engine<1>&, const ParticleSet<1>&, bool);
template Interactions countInteractions<2>(Engine<2>&, const ParticleSet<2>&, bool);
template Interactions countInteractions<3>(Engine<3>&, const ParticleSet<3>&, bool);

}  // namespace plenum
