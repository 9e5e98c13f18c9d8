// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/couette.hpp"

#include "engine/ordered_sum.hpp"
#include "solver/measures/relative_distance.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

Couette::Couette(const CouetteSettings& settings) : settings_(settings) {
  settings_.center.resize(2);
  const double r1 = settings.innerRadius * settings.innerRadius;
  const double r2 = settings.outerRadius * settings.outerRadius;
  const double w1 = settings.innerOmega, w2 = settings.outerOmega;
  A_ = (w2 * r2 - w1 * r1) / (r2 - r1);
  B_ = (w1 - w2) * r1 * r2 / (r2 - r1);
}

double Couette::speed(double radius) const {
  const double r = std::clamp(radius, settings_.innerRadius, settings_.outerRadius);
  return A_ * r + B_ / r;
}

Vec<2> Couette::fromCenter(const Vec<2>& x) const {
  return x - Vec<2>{{settings_.center[0], settings_.center[1]}};
}

double Couette::profileError(const Observed<2>& state) const {
  struct Ring {
    double n = 0, difference = 0;
  };
  std::vector<Ring> rings(static_cast<std::size_t>(settings_.bins));
  const double width = (settings_.outerRadius - settings_.innerRadius) / settings_.bins;
  const ParticleSet<2>& particles = state.particles;
  for (std::size_t i = 0; i < particles.nFluid(); ++i) {
    const Vec<2> r = fromCenter(particles[field::position][i]), v = particles[field::velocity][i];
    const double radius = norm(r), place = (radius - settings_.innerRadius) / width;
    if (!(place >= 0 && place < settings_.bins)) continue;
    Ring& ring = rings[static_cast<std::size_t>(place)];
    ring.n += 1;
    ring.difference += (r[0] * v[1] - r[1] * v[0]) / radius - speed(radius);
  }
  double worst = 0;
  for (const Ring& ring : rings)
    if (ring.n > 0) worst = std::max(worst, std::abs(ring.difference / ring.n));
  return worst / std::max(std::abs(settings_.innerOmega * settings_.innerRadius),
                          std::abs(settings_.outerOmega * settings_.outerRadius));
}

void Couette::addTo(std::vector<Figure>& row, const Observed<2>& state) const {
  const ParticleSet<2>& particles = state.particles;
  const auto distance = orderedSum<RelativeDistance>(particles.nFluid(), [&](std::size_t i) {
    const Vec<2> r = fromCenter(particles[field::position][i]);
    const double radius = norm(r);
    if (radius == 0) return RelativeDistance{norm(particles[field::velocity][i]), 0};
    const Vec<2> exact = speed(radius) / radius * Vec<2>{{-r[1], r[0]}};
    return RelativeDistance{norm(particles[field::velocity][i] - exact), norm(exact)};
  });
  row.push_back({"l1_velocity", "", distance.value()});
  row.push_back({"couette_profile_error", "", profileError(state)});
}

}  // namespace plenum
