// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/gresho.hpp"

#include "solver/measures/gas.hpp"

#include <array>
#include <cmath>

namespace plenum {

namespace {

struct Mean {
  double sum = 0, n = 0;
  void add(double value) {
    sum += value;
    n += 1;
  }
  double value() const { return n > 0 ? sum / n : std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace

template <int Dim>
Gresho<Dim>::Gresho(const GreshoSettings& settings, const Observed<Dim>& start,
                    const std::string& key)
    : settings_(settings),
      center_(vectorOf<Dim>(settings.center)),
      drift_(vectorOf<Dim>(settings.drift)) {
  requireIdealGas(start.settings, key);
}

template <int Dim>
double Gresho<Dim>::speed(double radius) const {
  const double x = radius / settings_.radius;
  return settings_.speed * (x < 1 ? x : x < 2 ? 2 - x : 0);
}

/// The integral of v_phi^2/r.
template <int Dim>
double Gresho<Dim>::pressureOverDensity(double radius) const {
  const double x = std::min(2.0, radius / settings_.radius);
  const double integral = x < 1 ? 0.5 * x * x : 0.5 * x * x + 4 * (1 - x + std::log(x));
  return settings_.speed * settings_.speed * integral;
}

template <int Dim>
void Gresho<Dim>::addTo(std::vector<Figure>& row, const Observed<Dim>& state) const {
  const ParticleSet<Dim>& particles = state.particles;
  const Vec<Dim> axis = center_ + state.info.time * drift_;
  // 5 a with room for roundings of particles at the box's end; its corners are 2.5 sqrt(2) a away.
  const double half = 2.5 * settings_.radius * (1 + 1e-9), ringWidth = settings_.radius / 20;
  Mean perParticle;
  struct Ring {
    Mean speed, exact;
  };
  std::array<Ring, 72> rings{};
  for (std::size_t i = 0; i < particles.nFluid(); ++i) {
    const Vec<Dim> x = state.info.domain.nearestImage(particles[field::position][i] - axis);
    if (std::abs(x[0]) > half || std::abs(x[1]) > half) continue;
    const Vec<Dim> v = particles[field::velocity][i] - drift_;
    const double r = std::hypot(x[0], x[1]);
    const double around = r > 0 ? (x[0] * v[1] - x[1] * v[0]) / r : std::hypot(v[0], v[1]);
    perParticle.add(std::abs(around - speed(r)));
    Ring& ring = rings[static_cast<std::size_t>(r / ringWidth)];
    ring.speed.add(around);
    ring.exact.add(speed(r));
  }
  Mean profile;
  for (const Ring& ring : rings)
    if (ring.speed.n > 0) profile.add(std::abs(ring.speed.value() - ring.exact.value()));
  row.push_back({"l1_velocity", "m/s", perParticle.value()});
  row.push_back({"l1_velocity_profile", "m/s", profile.value()});
}

template class Gresho<2>;
template class Gresho<3>;

}  // namespace plenum
