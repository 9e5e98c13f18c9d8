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

template <class Isa>
using Lanes = Pack<float, std::min<int>(Isa::bytes / sizeof(float), clusterSize), Isa>;

/// Bit k says whether box first + k is near.
template <class Real, int Dim>
[[gnu::always_inline]] inline unsigned nearBoxes(const BoxRows<Dim>& boxes, std::size_t first,
                                                 const FloatBox<Dim>& box) {
  Real distanceSquared(0);
  for (int a = 0; a < Dim; ++a) {
    const Real gap =
        positivePart(magnitude(Real::load(boxes.center[a] + first) - Real(box.center[a])) -
                     (Real::load(boxes.half[a] + first) + Real(box.half[a])));
    distanceSquared += gap * gap;
  }
  const Real reach = max(Real::load(boxes.reach + first), Real(box.reach));
  return lanesBelow(distanceSquared - reach * reach, 0.0f);
}

[[gnu::always_inline]] inline std::uint32_t* writePlaces(unsigned bits, std::size_t first,
                                                         std::uint32_t* next) {
  for (; bits != 0; bits &= bits - 1)
    *next++ = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(__builtin_ctz(bits));
  return next;
}

}  // namespace

template <class Isa, int Dim>
std::size_t selectBoxes(const BoxRows<Dim>& boxes, std::size_t n, const FloatBox<Dim>& box,
                        std::uint32_t* near) {
  using Real = Lanes<Isa>;
  std::uint32_t* next = near;
  for (std::size_t k = 0; k < n; k += Real::size)
    next = writePlaces(nearBoxes<Real>(boxes, k, box), k, next);
  return static_cast<std::size_t>(next - near);
}

template <class Isa, int Dim>
std::size_t selectInBlocks(const BoxRows<Dim>& boxes, const std::uint32_t* block,
                           std::size_t nBlocks, const FloatBox<Dim>& box, std::uint32_t* near) {
  using Real = Lanes<Isa>;
  std::uint32_t* next = near;
  for (std::size_t b = 0; b < nBlocks; ++b)
    for (std::size_t part = 0; part < blockSize; part += Real::size) {
      const std::size_t first = block[b] * blockSize + part;
      next = writePlaces(nearBoxes<Real>(boxes, first, box), first, next);
    }
  return static_cast<std::size_t>(next - near);
}

template <class Isa, int Dim>
std::size_t selectClusters(const float* points, const float* reach, const std::uint32_t* who,
                           const std::uint32_t* place, std::size_t n, const FloatBox<Dim>& box,
                           std::uint32_t* near) {
  using Real = Lanes<Isa>;
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
#define PLENUM_SELECT(Dim)                                                                         \
  template Size selectBoxes<Isa>(const BoxRows<Dim>&, Size, const FloatBox<Dim>&, Place*);         \
  template Size selectInBlocks<Isa>(const BoxRows<Dim>&, const Place*, Size, const FloatBox<Dim>&, \
                                    Place*);                                                       \
  template Size selectClusters<Isa>(const float*, const float*, const Place*, const Place*, Size,  \
                                    const FloatBox<Dim>&, Place*);
PLENUM_SELECT(1)
PLENUM_SELECT(2)
PLENUM_SELECT(3)

}  // namespace plenum
