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
                        const FloatBox<Dim>& box, float radius, std::uint32_t* near) {
  using Real = Pack<float, std::min<int>(Isa::bytes / sizeof(float), clusterSize), Isa>;
  const float limit = radius * radius;
  std::uint32_t* next = near;
  for (std::size_t k = first; k < last; k += Real::size) {
    Real distanceSquared(0);
    for (int a = 0; a < Dim; ++a) {
      const Real gap =
          positivePart(magnitude(Real::load(boxes.center[a] + k) - Real(box.center[a])) -
                       (Real::load(boxes.half[a] + k) + Real(box.half[a])));
      distanceSquared += gap * gap;
    }
    unsigned bits = lanesBelow(distanceSquared, limit);
    if (last - k < Real::size) bits &= (1u << (last - k)) - 1;
    for (; bits != 0; bits &= bits - 1)
      *next++ = static_cast<std::uint32_t>(k) + static_cast<std::uint32_t>(__builtin_ctz(bits));
  }
  return static_cast<std::size_t>(next - near);
}

template <class Isa, int Dim>
std::size_t selectClusters(const float* points, const std::uint32_t* who,
                           const std::uint32_t* place, std::size_t n, const FloatBox<Dim>& box,
                           float radius, std::uint32_t* near) {
  using Real = Pack<float, std::min<int>(Isa::bytes / sizeof(float), clusterSize), Isa>;
  const float limit = radius * radius;
  std::size_t nNear = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t cluster = who[place[k]];
    const float* x = points + std::size_t{cluster} * clusterSize * Dim;
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
      bits |= lanesBelow(distanceSquared, limit);
    }
    near[nNear] = cluster;
    nNear += bits != 0;
  }
  return nNear;
}

using Isa = isa::PLENUM_ISA;
using Place = std::uint32_t;
using Places = const Place*;
template std::size_t selectBoxes<Isa>(const BoxRows<1>&, std::size_t, std::size_t,
                                      const FloatBox<1>&, float, Place*);
template std::size_t selectBoxes<Isa>(const BoxRows<2>&, std::size_t, std::size_t,
                                      const FloatBox<2>&, float, Place*);
template std::size_t selectBoxes<Isa>(const BoxRows<3>&, std::size_t, std::size_t,
                                      const FloatBox<3>&, float, Place*);
template std::size_t selectClusters<Isa>(const float*, Places, Places, std::size_t,
                                         const FloatBox<1>&, float, Place*);
template std::size_t selectClusters<Isa>(const float*, Places, Places, std::size_t,
                                         const FloatBox<2>&, float, Place*);
template std::size_t selectClusters<Isa>(const float*, Places, Places, std::size_t,
                                         const FloatBox<3>&, float, Place*);

}  // namespace plenum
