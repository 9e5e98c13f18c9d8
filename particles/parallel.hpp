// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>

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

/// Calls body(k) for k = 0 ... n - 1 from all threads, for heavy work that may throw. An exception
/// (a geometry that cannot answer) leaves the loop after it has ended; of several the one with the
/// smallest k, whatever the number of threads.
template <class Body>
void parallelFor(std::size_t n, Body&& body) {
  std::exception_ptr failure;
  std::size_t failedAt = n;
#pragma omp parallel for schedule(dynamic) if (n > 1)
  for (std::size_t k = 0; k < n; ++k) {
    try {
      body(k);
    } catch (...) {
#pragma omp critical(plenumParallelFor)
      if (k < failedAt) {
        failedAt = k;
        failure = std::current_exception();
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace plenum
