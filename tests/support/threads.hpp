// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <omp.h>

#include <vector>

namespace plenum::test {

/// Runs `test` with 1, 2 and 3 threads and returns what it gave.
template <class Test>
auto forThreads(Test&& test) {
  std::vector<decltype(test())> results;
  for (const int nThreads : {1, 2, 3}) {
    omp_set_num_threads(nThreads);
    results.push_back(test());
  }
  omp_set_num_threads(omp_get_num_procs());
  return results;
}

}  // namespace plenum::test
