// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace plenum::test {

/// ParticleSet::permute with work space of its own.
template <class Particles>
void permute(Particles& particles, std::span<const std::uint32_t> order) {
  std::vector<std::byte> scratch(particles.size() * Particles::permuteBytes);
  particles.permute(order, scratch);
}

}  // namespace plenum::test
