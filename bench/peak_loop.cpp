// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once for each instruction set and precision: PLENUM_ISA and PLENUM_REAL.
#include "bench/peak.hpp"
#include "engine/pack.hpp"

namespace plenum::bench {

template <class Isa, class T>
T multiplyAdds(long rounds) {
  using Real = Pack<T, static_cast<int>(Isa::bytes / sizeof(T)), Isa>;
  Real sum[nChains];
  for (int k = 0; k < nChains; ++k) sum[k] = Real(k);
  const Real factor(0.5), addend(1);  // sums go to 2: neither infinite nor tiny
  for (long n = 0; n < rounds; ++n) {
#pragma GCC unroll 12
    for (int k = 0; k < nChains; ++k) sum[k] = sum[k] * factor + addend;
  }
  Real total;
  for (int k = 0; k < nChains; ++k) total += sum[k];
  return sumOfLanes(total);
}

template PLENUM_REAL multiplyAdds<isa::PLENUM_ISA, PLENUM_REAL>(long);

}  // namespace plenum::bench
