// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/pack.hpp"
#include "engine/tile_work.hpp"

namespace plenum {

/// `adaptive`: each particle has its own smoothing length.
template <class Real, int Dim, bool adaptive>
class NearTiles {
  using T = typename Real::Scalar;
  static constexpr int n = static_cast<int>(clusterSize);
  static constexpr int nReceivers = n / 2;
  static constexpr int lanes = Real::size;

 public:
  NearTiles(const TileWork<Dim, T>& work, double radius)
      : work_(work), limit_(static_cast<T>(radius * radius)) {}

  void find() const {
    std::uint16_t* tile = work_.tiles;
    for (std::uint32_t half = 0; half < 2 * work_.nClusters; ++half) {
      TileCounts& count = work_.counts[half];
      const T* block = work_.positions + std::size_t{work_.locals[half / 2].cluster} * (Dim * n) +
                       half % 2 * nReceivers;
      Receiver x[nReceivers];
      for (int c = 0; c < nReceivers; ++c) {
        for (int a = 0; a < Dim; ++a) x[c].position[a] = Real(block[a * n + c]);
        if constexpr (adaptive)
          x[c].reachSquared = reachSquared(
              Real(lengthsOf(half / 2)[half % 2 * nReceivers + static_cast<unsigned>(c)]));
      }
      const Vec<Dim>& origin = work_.locals[half / 2].origin;
      count.nearSelf = nearFirst(x, origin, tile, count.self);
      tile += count.self;
      count.nearFluid = nearFirst(x, origin, tile, count.fluid);
      tile += count.fluid;
      count.nearWall = nearFirst(x, origin, tile, count.wall);
      tile += count.wall;
    }
  }

 private:
  struct Receiver {
    Real position[Dim];
    Real reachSquared;
  };

  [[gnu::always_inline]] Real reachSquared(Real h) const { return Real(limit_) * h * h; }

  const T* lengthsOf(std::size_t local) const {
    return work_.smoothingLengths + std::size_t{work_.locals[local].cluster} * n;
  }

  /// Swaps each near tile with the first one that is not; without a branch.
  [[gnu::always_inline]] std::uint16_t nearFirst(const Receiver (&x)[nReceivers],
                                                 const Vec<Dim>& origin, std::uint16_t* tile,
                                                 std::uint32_t count) const {
    std::uint32_t nNear = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint16_t candidate = tile[k];
      const bool near = isNear(x, origin, candidate);
      tile[k] = tile[nNear];
      tile[nNear] = candidate;
      nNear += near;
    }
    return static_cast<std::uint16_t>(nNear);
  }

  [[gnu::always_inline]] bool isNear(const Receiver (&x)[nReceivers], const Vec<Dim>& origin,
                                     std::size_t candidate) const {
    const LocalCluster<Dim>& local = work_.locals[candidate];
    const T* block = work_.positions + std::size_t{local.cluster} * (Dim * n);
    const T bound = adaptive ? T(0) : limit_;
    Real least(bound);
    for (int part = 0; part < n; part += lanes) {
      Real y[Dim];
      for (int a = 0; a < Dim; ++a)
        y[a] = Real::load(block + a * n + part) + Real(static_cast<T>(local.origin[a] - origin[a]));
      Real reachOfPart;
      if constexpr (adaptive) reachOfPart = reachSquared(Real::load(lengthsOf(candidate) + part));
      for (int c = 0; c < nReceivers; ++c) {
        Real distanceSquared(0);
        for (int a = 0; a < Dim; ++a)
          distanceSquared += (x[c].position[a] - y[a]) * (x[c].position[a] - y[a]);
        if constexpr (adaptive) distanceSquared -= max(x[c].reachSquared, reachOfPart);
        least = min(least, distanceSquared);
      }
    }
    return lanesBelow(least, bound) != 0;
  }

  const TileWork<Dim, T>& work_;
  T limit_;
};

}  // namespace plenum
