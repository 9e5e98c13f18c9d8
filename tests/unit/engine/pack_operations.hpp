// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operations of packs behind plain pointers: they are compiled for every instruction set, the test
// that calls them for the least.
#pragma once

namespace plenum::test {

enum class PackOperation {
  add,
  subtract,
  multiply,
  divide,
  addTo,
  subtractFrom,
  multiplyBy,
  negate,
  larger,
  smaller,
  chooseSmaller,
  positive,
  negative,
  root,
  fifthPower,
  fill,
  sum,    ///< out[0]
  below,  ///< out[0]: the bits of the lanes of a that are smaller than b[0]
  count
};

/// The result for `N` lanes of `a` and `b` in `out`.
template <class Isa, class T, int N>
void apply(PackOperation operation, const T* a, const T* b, T* out);

}  // namespace plenum::test
