// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>
#include <limits>

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

/// An exception that must not leave a parallel loop; of several that of the smallest index,
/// whatever the number of threads.
class FirstFailure {
 public:
  template <class Body>
  void watch(std::size_t k, Body&& body) {
    try {
      body();
    } catch (...) {
#pragma omp critical(plenumFirstFailure)
      if (k < failedAt_) {
        failedAt_ = k;
        failure_ = std::current_exception();
      }
    }
  }
  /// After the loop.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::exception_ptr failure_;
  std::size_t failedAt_ = std::numeric_limits<std::size_t>::max();
};

/// Calls body(k) for k = 0 ... n - 1 from all threads, for heavy work that may throw (a geometry
/// that cannot answer).
template <class Body>
void parallelFor(std::size_t n, Body&& body) {
  FirstFailure failure;
#pragma omp parallel for schedule(dynamic) if (n > 1)
  for (std::size_t k = 0; k < n; ++k) failure.watch(k, [&] { body(k); });
  failure.rethrow();
}

}  // namespace plenum
