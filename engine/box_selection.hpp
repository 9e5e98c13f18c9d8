// SPDX-License-Identifier: GPL-3.0-or-later
//
// The inner loops of the search for tiles: which of many boxes, which of some clusters, are near a
// box. Plain pointers only, as in tile_work.hpp. Places are relative to a chunk, in float and in
// units of length.
#pragma once

#include "engine/spatial_order.hpp"
#include "particles/vec.hpp"

#include <cstdint>

namespace plenum {

template <int Dim>
struct FloatBox {
  Vec<Dim, float> center, half;
  float reach;  ///< at which distance its particles see others
};

/// Boxes as arrays, padded to whole packs with boxes that are far from everything.
template <int Dim>
struct BoxRows {
  const float* center[Dim];
  const float* half[Dim];
  const float* reach;
};

/// Boxes in a block: they are told from a far box by the box around them all.
inline constexpr std::size_t blockSize = 8;

/// How many boxes a padded array has room for at its end.
inline constexpr std::size_t boxPadding = 16;

/// Writes the places in [0, n) of the boxes closer to a box than the larger reach of the two to
/// `near`, in order; returns their number. `near` has room for n + boxPadding.
template <class Isa, int Dim>
std::size_t selectBoxes(const BoxRows<Dim>& boxes, std::size_t n, const FloatBox<Dim>& box,
                        std::uint32_t* near);

/// The same among the boxes of some blocks: those with the places block[k] blockSize to
/// (block[k] + 1) blockSize, k < nBlocks.
template <class Isa, int Dim>
std::size_t selectInBlocks(const BoxRows<Dim>& boxes, const std::uint32_t* block,
                           std::size_t nBlocks, const FloatBox<Dim>& box, std::uint32_t* near);

/// Of the clusters who[place[k]], k < n, those that have a particle closer to a box than the larger
/// of reach[cluster] and the box's: writes them to `near` in order and returns their number.
/// `points` are positions as [cluster][axis][particle]. `near` may be `place`.
template <class Isa, int Dim>
std::size_t selectClusters(const float* points, const float* reach, const std::uint32_t* who,
                           const std::uint32_t* place, std::size_t n, const FloatBox<Dim>& box,
                           std::uint32_t* near);

}  // namespace plenum
