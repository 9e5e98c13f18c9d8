// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/engine/pack_operations.hpp"

#include "engine/instruction_set.hpp"
#include "engine/pack.hpp"

namespace plenum::test {

template <class Isa, class T, int N>
void apply(PackOperation operation, const T* first, const T* second, T* out) {
  using P = Pack<T, N, Isa>;
  const P a = P::load(first), b = P::load(second);
  P c = a;
  switch (operation) {
    case PackOperation::add:
      return (a + b).store(out);
    case PackOperation::subtract:
      return (a - b).store(out);
    case PackOperation::multiply:
      return (a * b).store(out);
    case PackOperation::divide:
      return (a / b).store(out);
    case PackOperation::addTo:
      return (c += b).store(out);
    case PackOperation::subtractFrom:
      return (c -= b).store(out);
    case PackOperation::multiplyBy:
      return (c *= b).store(out);
    case PackOperation::negate:
      return (-a).store(out);
    case PackOperation::larger:
      return max(a, b).store(out);
    case PackOperation::smaller:
      return min(a, b).store(out);
    case PackOperation::chooseSmaller:
      return select(a < b, a, b).store(out);
    case PackOperation::positive:
      return positivePart(a).store(out);
    case PackOperation::negative:
      return negativePart(a).store(out);
    case PackOperation::root:
      return squareRoot(a).store(out);
    case PackOperation::fifthPower:
      return power<5>(a).store(out);
    case PackOperation::fill:
      return P(first[0]).store(out);
    case PackOperation::sum:
      out[0] = sumOfLanes(a);
      return;
    case PackOperation::below:
      out[0] = static_cast<T>(lanesBelow(a, second[0]));
      return;
    case PackOperation::count:
      return;
  }
}

using Isa = isa::PLENUM_ISA;
using T = PLENUM_REAL;
template void apply<Isa, T, 2>(PackOperation, const T*, const T*, T*);
template void apply<Isa, T, 4>(PackOperation, const T*, const T*, T*);
template void apply<Isa, T, 8>(PackOperation, const T*, const T*, T*);

}  // namespace plenum::test
