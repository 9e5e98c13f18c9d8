// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace plenum {

/// Sum of value(i) over i in [0, n): in parallel, but with the same bits for any number of threads,
/// because blocks of fixed size are added up in order. `Value` needs `+=` and a zero.
template <class Value, class Function>
Value orderedSum(std::size_t n, Function&& value) {
  constexpr std::size_t blockSize = 4096;
  const std::size_t nBlocks = (n + blockSize - 1) / blockSize;
  std::vector<Value> partial(nBlocks);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(nBlocks); ++b) {
    const std::size_t first = static_cast<std::size_t>(b) * blockSize;
    const std::size_t last = std::min(n, first + blockSize);
    Value sum{};
    for (std::size_t i = first; i < last; ++i) sum += value(i);
    partial[static_cast<std::size_t>(b)] = sum;
  }
  Value total{};
  for (const Value& p : partial) total += p;
  return total;
}

}  // namespace plenum
