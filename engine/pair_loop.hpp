// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one loop over neighbours. A pass names a kernel and the terms that share the loop; what the
// terms read is loaded, what they write is stored, the rest costs nothing.
#pragma once

#include "engine/layout.hpp"
#include "engine/pack.hpp"
#include "engine/pair.hpp"
#include "engine/tile_work.hpp"
#include "engine/units.hpp"
#include "particles/kernels.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace plenum {

/// A profile for particles that have a smoothing length each.
template <class Profile>
struct Adaptive : Profile {};

template <class Profile>
inline constexpr bool isAdaptive = false;
template <class Profile>
inline constexpr bool isAdaptive<Adaptive<Profile>> = true;

/// One loop over all pairs. `Profile` is a kernel of particles/kernels.hpp or kernel::Any, or
/// Adaptive of one.
template <class Profile, class... Terms>
struct Pass {
  static constexpr FieldSet reads =
      ((isAdaptive<Profile> ? FieldSet{field::smoothingLength} : FieldSet{}) | ... | Terms::reads);
  static constexpr FieldSet writes = (FieldSet{} | ... | Terms::writes);

  Profile profile;
  double smoothingLength;  ///< h of all particles [m]; unused if they have their own
  std::tuple<Terms...> terms;

  /// The same pass for numbers in `units`.
  Pass inUnits(const Units& units) const {
    return {profile,
            smoothingLength / units.length,
            {plenum::inUnits(std::get<Terms>(terms), units)...}};
  }
};

/// sigma of a profile that is known at compile time or chosen at run time.
template <int Dim, class Profile>
constexpr double sigmaOf(const Profile& profile) {
  if constexpr (requires { profile.sigma(Dim); })
    return profile.sigma(Dim);
  else
    return Profile::sigma[Dim - 1];
}

/// Sums the terms of a pass over the near tiles of a chunk. `Real` is a pack of at most
/// `clusterSize` neighbours of one receiver.
template <class Real, int Dim, class Profile, class... Terms>
class TileLoop {
  using T = typename Real::Scalar;
  using P = Pass<Profile, Terms...>;
  using View = ParticleView<Real, Dim>;
  using Pair_ = Pair<Real, Dim>;

  static constexpr int nIn = componentsOf<Dim>(P::reads), nOut = componentsOf<Dim>(P::writes);
  static constexpr int n = static_cast<int>(clusterSize);
  static constexpr int nReceivers = n / 2;  // of a tile
  static constexpr int lanes = Real::size;

  /// The numbers of `writes`, one after the other.
  struct Totals {
    Real of[nOut];
  };

  /// W and F for one smoothing length.
  struct Scale {
    Real h, inverseH, sigmaW, sigmaF;

    Scale() = default;
    [[gnu::always_inline]] Scale(Real sigma, Real length) : h(length), inverseH(Real(1) / length) {
      sigmaW = sigma * power<Dim>(inverseH);
      sigmaF = sigmaW * (inverseH * inverseH);
    }
    [[gnu::always_inline]] KernelValues<Real> at(const Profile& profile, Real distance) const {
      const Real R = distance * inverseH;
      return {sigmaW * profile.f(R), sigmaF * profile.g(R)};
    }
  };
  struct NoScale {};

  struct Particle {
    Vec<Dim, Real> position;
    View view;
    [[no_unique_address]] std::conditional_t<isAdaptive<Profile>, Scale, NoScale> scale;
  };

  /// What is the same for all pairs.
  struct Constants {
    P pass;
    Real sigma;
    Scale scale;  // of the one smoothing length that all have

    explicit Constants(const P& p)
        : pass(p), sigma(sigmaOf<Dim>(p.profile)), scale(sigma, Real(p.smoothingLength)) {}
  };

 public:
  TileLoop(const TileWork<Dim, T>& work, const P& pass) : work_(work), constants_(pass) {}

  void run() const {
    const std::uint16_t* tile = work_.tiles;
    for (std::uint32_t half = 0; half < 2 * work_.nClusters; ++half) {
      sumHalf(half, tile, work_.counts[half]);
      tile += work_.counts[half].all();
    }
  }

 private:
  /// The sums of half a cluster, and those that its tiles give to the neighbours.
  void sumHalf(std::uint32_t half, const std::uint16_t* tile, const TileCounts& count) const {
    const std::size_t own = half / 2;
    const std::size_t firstLane = half % 2 * nReceivers;
    const Vec<Dim> origin = work_.locals[own].origin;
    Particle receivers[nReceivers];
    for (std::size_t c = 0; c < nReceivers; ++c)
      receivers[c] =
          particle(work_.locals[own].cluster, [&](const T* x) { return Real(x[firstLane + c]); });
    Totals totals[nReceivers];
    if (work_.fluidTiles) {
      addTiles<false>(receivers, totals, origin, tile, count.nearSelf);
      addTiles<true>(receivers, totals, origin, tile + count.self, count.nearFluid);
    }
    if (work_.wallTiles && count.nearWall > 0) {
      tile += count.self + count.fluid;
      Totals fromWalls[nReceivers];
      if (work_.toWalls)
        addTiles<true>(receivers, fromWalls, origin, tile, count.nearWall);
      else
        addTiles<false>(receivers, fromWalls, origin, tile, count.nearWall);
      if (work_.fromWalls)
        for (int c = 0; c < nReceivers; ++c)
          for (int k = 0; k < nOut; ++k) totals[c].of[k] += fromWalls[c].of[k];
    }
    T* out = work_.sums + std::size_t{work_.locals[own].sums} * (nOut * n) + firstLane;
    for (int k = 0; k < nOut; ++k)
      for (int c = 0; c < nReceivers; ++c) out[k * n + c] += sumOfLanes(totals[c].of[k]);
  }

  template <bool toNeighbours>
  [[gnu::noinline]] void addTiles(const Particle (&receivers)[nReceivers],
                                  Totals (&totals)[nReceivers], const Vec<Dim>& origin,
                                  const std::uint16_t* tiles, std::uint32_t nTiles) const {
    const Constants constants = constants_;  // a copy that no store can change
    for (std::uint32_t k = 0; k < nTiles; ++k) {
      const LocalCluster<Dim>& local = work_.locals[tiles[k]];
      loadAhead<toNeighbours>(work_.locals[tiles[std::min(k + 1, nTiles - 1)]]);
      for (int part = 0; part < n; part += lanes) {
        Particle neighbour =
            particle(local.cluster, [&](const T* x) { return Real::load(x + part); });
        for (int a = 0; a < Dim; ++a)
          neighbour.position[a] += Real(static_cast<T>(local.origin[a] - origin[a]));
        Totals back;
#pragma GCC unroll 4
        for (int c = 0; c < nReceivers; ++c)
          addPair<toNeighbours>(constants, receivers[c], neighbour, totals[c], back);
        if constexpr (toNeighbours) {
          T* out = work_.sums + std::size_t{local.sums} * (nOut * n) + part;
          for (int q = 0; q < nOut; ++q) (Real::load(out + q * n) + back.of[q]).store(out + q * n);
        }
      }
    }
  }

  /// Asks for the numbers of the next tile's neighbours while those of this one are computed.
  template <bool toNeighbours>
  [[gnu::always_inline]] void loadAhead(const LocalCluster<Dim>& local) const {
    constexpr int line = 64 / sizeof(T);
    const auto ask = [](const T* from, int count) __attribute__((always_inline)) {
#pragma GCC unroll 16
      for (int k = 0; k < count; k += line) __builtin_prefetch(from + k);
    };
    ask(work_.positions + local.cluster * std::size_t{Dim * n}, Dim * n);
    ask(work_.fields + local.cluster * std::size_t{nIn * n}, nIn * n);
    if constexpr (toNeighbours) ask(work_.sums + std::size_t{local.sums} * (nOut * n), nOut * n);
  }

  /// Both sides of a pair: what they share is computed once.
  template <bool toNeighbours>
  [[gnu::always_inline]] static void addPair(const Constants& constants, const Particle& i,
                                             const Particle& j, Totals& totalsI, Totals& totalsJ) {
    const Profile& profile = constants.pass.profile;
    const Vec<Dim, Real> r = i.position - j.position;
    const Real distanceSquared = normSquared(r);
    const Real distance = squareRoot(distanceSquared);
    Real vDotR;
    if constexpr (P::reads.has(FieldId::velocity))
      vDotR = dot(i.view.velocity - j.view.velocity, r);
    Real h, W, F;
    KernelValues<Real> ofI, ofJ;
    if constexpr (isAdaptive<Profile>) {
      ofI = i.scale.at(profile, distance);
      ofJ = j.scale.at(profile, distance);
      h = Real(0.5) * (i.scale.h + j.scale.h);
      W = Real(0.5) * (ofI.W + ofJ.W);
      F = Real(0.5) * (ofI.F + ofJ.F);
    } else {
      ofI = ofJ = constants.scale.at(profile, distance);
      h = constants.scale.h;
      W = ofI.W;
      F = ofI.F;
    }
    const Pair_ ij{i.view, j.view, r, distanceSquared, vDotR, h, W, F, ofI, ofJ};
    const Pair_ ji{j.view, i.view, -r, distanceSquared, vDotR, h, W, F, ofJ, ofI};
    Exchange<Real, Dim> exchange;
    Sums<Real, Dim> toI, toJ, toEach;
    const auto evaluate = [&](const auto& term) __attribute__((always_inline)) {
      using Term = std::remove_cvref_t<decltype(term)>;
      if constexpr (Exchanges<Term, Real, Dim>) {
        term(ij, exchange);
      } else if constexpr (ExchangesAndGives<Term, Real, Dim>) {
        term(ij, exchange, toEach);
      } else {
        term(ij, toI);
        if constexpr (toNeighbours) term(ji, toJ);
      }
    };
    (evaluate(std::get<Terms>(constants.pass.terms)), ...);
    add(
        exchange, F, r, [&](int k, Real x) __attribute__((always_inline)) {
          totalsI.of[k] += x;
          if constexpr (toNeighbours) totalsJ.of[k] -= x;
        });
    if constexpr ((ExchangesAndGives<Terms, Real, Dim> || ...))
      add(
          toEach, F, r, [&](int k, Real x) __attribute__((always_inline)) {
            totalsI.of[k] += x;
            if constexpr (toNeighbours) totalsJ.of[k] += x;
          });
    add(
        toI, F, r, [&](int k, Real x) __attribute__((always_inline)) { totalsI.of[k] += x; });
    if constexpr (toNeighbours)
      add(
          toJ, F, -r, [&](int k, Real x) __attribute__((always_inline)) { totalsJ.of[k] += x; });
  }

  /// Calls put(k, number) for each number of `writes` that is in `sums`.
  template <class SumsOrExchange, class Put>
  [[gnu::always_inline]] static void add(const SumsOrExchange& sums, Real F,
                                         const Vec<Dim, Real>& r, Put&& put) {
    SumsOrExchange::forEachMember([&](auto tag, auto member) __attribute__((always_inline)) {
      if constexpr (P::writes.has(tag)) {
        constexpr int first = offsetOf<Dim>(P::writes, tag);
        if constexpr (infoOf(tag).rank == Rank::vector) {
          const Real factor = (sums.*member).alongGradW * F + (sums.*member).alongR;
          const Vec<Dim, Real>& rest = (sums.*member).rest;
          put(first, factor * r[0] + rest[0]);
          if constexpr (Dim > 1) put(first + 1, factor * r[1] + rest[1]);
          if constexpr (Dim > 2) put(first + 2, factor * r[2] + rest[2]);
        } else {
          put(first, sums.*member);
        }
      }
    });
  }

  /// A particle, or as many as `load` takes from a row of a cluster's numbers.
  template <class Load>
  [[gnu::always_inline]] Particle particle(std::size_t cluster, Load&& load) const {
    const T* position = work_.positions + cluster * (Dim * n);
    const T* fields = work_.fields + cluster * (nIn * n);
    Particle p;
    for (int a = 0; a < Dim; ++a) p.position[a] = load(position + a * n);
    View::forEachMember([&](auto tag, auto member) {
      if constexpr (P::reads.has(tag)) {
        constexpr int first = offsetOf<Dim>(P::reads, tag);
        if constexpr (infoOf(tag).rank == Rank::vector)
          for (int a = 0; a < Dim; ++a) (p.view.*member)[a] = load(fields + (first + a) * n);
        else
          p.view.*member = load(fields + first * n);
      }
    });
    if constexpr (isAdaptive<Profile>) p.scale = Scale(constants_.sigma, p.view.smoothingLength);
    return p;
  }

  const TileWork<Dim, T>& work_;
  Constants constants_;
};

/// A TileFunction for a Pass whose type is known.
template <class Real, int Dim, class Profile, class... Terms>
void sumTiles(const TileWork<Dim, typename Real::Scalar>& work, const void* pass) {
  TileLoop<Real, Dim, Profile, Terms...>(work, *static_cast<const Pass<Profile, Terms...>*>(pass))
      .run();
}

}  // namespace plenum
