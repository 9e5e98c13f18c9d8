// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>

namespace plenum {

/// Calls body(k) for k = 0 ... n - 1 from all threads. An exception (a geometry that cannot answer)
/// leaves the loop after it has ended; of several the one with the smallest k, whatever the number
/// of threads.
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
