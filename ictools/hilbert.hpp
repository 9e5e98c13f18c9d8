// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace plenum {

/// Bits of a coordinate that a key of 64 bits has room for.
template <int Dim>
inline constexpr int hilbertBits = Dim == 1 ? 63 : 63 / Dim;

/// Place of a cell along Hilbert's curve through a grid of 2^hilbertBits cells an axis; cells that
/// follow each other share a face. Skilling 2004, doi 10.1063/1.1751381.
template <int Dim>
std::uint64_t hilbertKey(std::array<std::uint64_t, Dim> x) {
  if constexpr (Dim == 1) return x[0];
  constexpr int bits = hilbertBits<Dim>;
  const std::uint64_t top = std::uint64_t{1} << (bits - 1);
  for (std::uint64_t q = top; q > 1; q >>= 1) {
    const std::uint64_t below = q - 1;
    for (std::size_t a = 0; a < Dim; ++a) {
      if ((x[a] & q) != 0) {
        x[0] ^= below;
      } else {
        const std::uint64_t swapped = (x[0] ^ x[a]) & below;
        x[0] ^= swapped;
        x[a] ^= swapped;
      }
    }
  }
  for (std::size_t a = 1; a < Dim; ++a) x[a] ^= x[a - 1];
  std::uint64_t flip = 0;
  for (std::uint64_t q = top; q > 1; q >>= 1)
    if ((x[Dim - 1] & q) != 0) flip ^= q - 1;
  for (std::uint64_t& coordinate : x) coordinate ^= flip;
  std::uint64_t key = 0;
  for (int bit = bits - 1; bit >= 0; --bit)
    for (std::size_t a = 0; a < Dim; ++a) key = key << 1 | (x[a] >> bit & 1);
  return key;
}

}  // namespace plenum
