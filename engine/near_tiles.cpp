// SPDX-License-Identifier: GPL-3.0-or-later
//
// The engine's own loops over tiles, for the instruction set that this source is compiled for.
#include "engine/near_tiles.hpp"
#include "engine/instruction_set.hpp"

namespace plenum {

template <class Isa, class T, int Dim>
void findNearTiles(const TileWork<Dim, T>& work, double radius) {
  constexpr int lanes = std::min<int>(Isa::bytes / sizeof(T), clusterSize);
  using Real = Pack<T, lanes, Isa>;
  if (work.smoothingLengths == nullptr)
    NearTiles<Real, Dim, false>(work, radius).find();
  else
    NearTiles<Real, Dim, true>(work, radius).find();
}

using Isa = isa::PLENUM_ISA;
using T = PLENUM_REAL;
template void findNearTiles<Isa, T, 1>(const TileWork<1, T>&, double);
template void findNearTiles<Isa, T, 2>(const TileWork<2, T>&, double);
template void findNearTiles<Isa, T, 3>(const TileWork<3, T>&, double);

}  // namespace plenum
