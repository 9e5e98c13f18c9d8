// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/peak.hpp"

#include "bench/clocks.hpp"

#include <omp.h>

namespace plenum::bench {

namespace {

template <class T>
double measured(int threads) {
  const auto [loop, lanes] = withInstructionSet(instructionSet(), [](auto isa) {
    using Isa = decltype(isa);
    return std::pair(&multiplyAdds<Isa, T>, static_cast<int>(Isa::bytes / sizeof(T)));
  });
  constexpr long rounds = 4'000'000;
  constexpr int repeats = 3;  // the first wakes threads and clock
  omp_set_num_threads(threads);
  Times spent;
  volatile T sink = 0;
  for (int k = 0; k < repeats; ++k) {
    const Times start = now();
#pragma omp parallel
    {
      const T sum = loop(rounds);
#pragma omp atomic write
      sink = sum;
    }
    spent = now() - start;
  }
  return 2.0 * lanes * nChains * static_cast<double>(rounds) * threads / spent.counted(threads) *
         1e-9;
}

}  // namespace

double peakGflops(bool inDouble, int threads) {
  return inDouble ? measured<double>(threads) : measured<float>(threads);
}

}  // namespace plenum::bench
