// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/shifting.hpp"

#include <atomic>
#include <cmath>

namespace plenum {

namespace {

/// The largest of what several threads find, in whatever order.
void raise(std::atomic<double>& largest, double value) {
  double seen = largest.load(std::memory_order_relaxed);
  while (value > seen && !largest.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
}

}  // namespace

template <int Dim>
double shift(const ShiftingSettings& settings, double h, double dt, const Engine<Dim>& engine,
             ParticleSet<Dim>& particles) {
  // Of a full neighbourhood -sum V r.grad W is d; a plane surface has about half of it, and one
  // spacing below there is three quarters: Lee et al. 2008 have 1.5 in 2-D.
  const double leastInside = settings.freeSurface ? 0.75 * Dim : -1e300;
  const double mostAtOnce = 0.1 * h;
  std::atomic<double> longest = 0;
  const auto position = particles[field::position];
  const auto velocity = std::as_const(particles)[field::velocity];
  engine.forEachSum(
      Group::fluids,
      [&](std::size_t i, const Vec<Dim>& gradient, double divergence) {
        if (divergence < leastInside) return;
        Vec<Dim> way = -(settings.coefficient * h * norm(velocity[i]) * dt) * gradient;
        const double length = norm(way);
        if (length > mostAtOnce) way = (mostAtOnce / length) * way;
        position[i] += way;
        raise(longest, std::min(length, mostAtOnce));
      },
      field::kernelGradient, field::positionDivergence);
  return longest;
}

template double shift(const ShiftingSettings&, double, double, const Engine<1>&, ParticleSet<1>&);
template double shift(const ShiftingSettings&, double, double, const Engine<2>&, ParticleSet<2>&);
template double shift(const ShiftingSettings&, double, double, const Engine<3>&, ParticleSet<3>&);

}  // namespace plenum
