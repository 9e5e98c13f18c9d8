// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a loop over tiles gets: plain pointers only, because the loop may be compiled for a newer
// processor than the rest of the program, and nothing that both compile may be shared.
#pragma once

#include "engine/tile_list.hpp"

namespace plenum {

/// The tiles of a chunk, and the numbers of all clusters, in the engine's units. In a block, the
/// `clusterSize` numbers of one component follow each other.
template <int Dim, class T>
struct TileWork {
  TileCounts* counts;    ///< of half clusters, two a cluster of the chunk
  std::uint16_t* tiles;  ///< places in `locals`; the near ones of each kind come first
  const LocalCluster<Dim>* locals;
  std::uint32_t nClusters;    ///< of the chunk itself: the first of `locals`
  const T* positions;         ///< [cluster][axis][particle], relative to the cluster's origin
  const T* smoothingLengths;  ///< [cluster][particle]; null if all have the same support
  const T* fields;            ///< [cluster][component][particle], what the pass reads
  T* sums;                    ///< [place][component][particle], what the pass writes
  bool fluidTiles;            ///< sums from fluids are asked for
  bool wallTiles;             ///< tiles with walls are needed
  bool fromWalls;             ///< the receivers get their sums
  bool toWalls;               ///< the walls get theirs
};

/// Adds the sums of a chunk's near tiles to `work.sums`. `pass` is what the function was made for.
template <int Dim, class T>
using TileFunction = void (*)(const TileWork<Dim, T>& work, const void* pass);

/// Moves the tiles that hold a pair closer than `radius` to the front of their kind, and counts
/// them. `work` has positions and tiles. `radius` is in units of length, or in smoothing lengths of
/// the one of the two that has the larger.
template <class Isa, class T, int Dim>
void findNearTiles(const TileWork<Dim, T>& work, double radius);

}  // namespace plenum
