// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once for each instruction set.
#include "engine/box_selection.hpp"

#include "engine/instruction_set.hpp"
#include "engine/pack.hpp"

#include <algorithm>

namespace plenum {

namespace {
template <class Real>
[[gnu::always_inline]] inline Real magnitude(Real a) {
  return max(a, -a);
}
}  // namespace

template <class Isa, int Dim>
std::size_t selectBoxes(const BoxRows<Dim>& boxes, std::size_t first, std::size_t last,
                        const FloatBox<Dim>& box, std::uint32_t* near) {
  using Real = Pack<float, std::min<int>(Isa::bytes / sizeof(float), clusterSize), Isa>;
  std::uint32_t* next = near;
  for (std::size_t k = first; k < last; k += Real::size) {
    Real distanceSquared(0);
    for (int a = 0; a < Dim; ++a) {
      const Real gap =
          positivePart(magnitude(Real::load(boxes.center[a] + k) - Real(box.center[a])) -
                       (Real::load(boxes.half[a] + k) + Real(box.half[a])));
      distanceSquared += gap * gap;
    }
    const Real reach = max(Real::load(boxes.reach + k), Real(box.reach));
    unsigned bits = lanesBelow(distanceSquared - reach * reach, 0.0f);
    if (last - k < Real::size) bits &= (1u << (last - k)) - 1;
    for (; bits != 0; bits &= bits - 1)
      *next++ = static_cast<std::uint32_t>(k) + static_cast<std::uint32_t>(__builtin_ctz(bits));
  }
  return static_cast<std::size_t>(next - near);
}

template <class Isa, int Dim>
std::size_t selectClusters(const float* points, const float* reach, const std::uint32_t* who,
                           const std::uint32_t* place, std::size_t n, const FloatBox<Dim>& box,
                           std::uint32_t* near) {
  using Real = Pack<float, std::min<int>(Isa::bytes / sizeof(float), clusterSize), Isa>;
  std::size_t nNear = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t cluster = who[place[k]];
    const float* x = points + std::size_t{cluster} * clusterSize * Dim;
    const float larger = reach[cluster] > box.reach ? reach[cluster] : box.reach;
    unsigned bits = 0;
    for (std::size_t part = 0; part < clusterSize; part += Real::size) {
      Real distanceSquared(0);
      for (int a = 0; a < Dim; ++a) {
        const Real gap = positivePart(
            magnitude(Real::load(x + static_cast<std::size_t>(a) * clusterSize + part) -
                      Real(box.center[a])) -
            Real(box.half[a]));
        distanceSquared += gap * gap;
      }
      bits |= lanesBelow(distanceSquared, larger * larger);
    }
    near[nNear] = cluster;
    nNear += bits != 0;
  }
  return nNear;
}

using Isa = isa::PLENUM_ISA;
using Size = std::size_t;
using Place = std::uint32_t;
#define PLENUM_SELECT(Dim)                                                                        \
  template Size selectBoxes<Isa>(const BoxRows<Dim>&, Size, Size, const FloatBox<Dim>&, Place*);  \
  template Size selectClusters<Isa>(const float*, const float*, const Place*, const Place*, Size, \
                                    const FloatBox<Dim>&, Place*);
PLENUM_SELECT(1)
PLENUM_SELECT(2)
PLENUM_SELECT(3)

}  // namespace plenum
