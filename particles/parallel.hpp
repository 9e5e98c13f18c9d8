// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace plenum {

/// Below this many light operations a parallel loop costs more than it saves.
inline constexpr std::size_t worthThreads = 8192;

/// Calls body(i) for i = 0 ... n - 1; the calls must not depend on each other and must not throw.
/// For light work on each particle; from `worthThreads` on in all threads.
template <class Body>
void forEachIndex(std::size_t n, Body&& body) {
#pragma omp parallel for schedule(static) if (n >= worthThreads)
  for (std::size_t i = 0; i < n; ++i) body(i);
}

}  // namespace plenum
