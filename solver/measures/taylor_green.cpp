// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/taylor_green.hpp"

#include "engine/ordered_sum.hpp"
#include "solver/measures/relative_distance.hpp"

#include <cmath>
#include <numbers>

namespace plenum {

TaylorGreen::TaylorGreen(const TaylorGreenSettings& settings)
    : settings_(settings), k_(2 * std::numbers::pi / settings.length) {
  settings_.origin.resize(2);
}

Vec<2> TaylorGreen::phase(const Vec<2>& x) const {
  return k_ * (x - Vec<2>{{settings_.origin[0], settings_.origin[1]}});
}

double TaylorGreen::speed(double time) const {
  return settings_.speed * std::exp(-2 * settings_.viscosity * k_ * k_ * time);
}

Vec<2> TaylorGreen::velocity(const Vec<2>& x, double time) const {
  const Vec<2> a = phase(x);
  return speed(time) * Vec<2>{{-std::cos(a[0]) * std::sin(a[1]), std::sin(a[0]) * std::cos(a[1])}};
}

double TaylorGreen::pressure(const Vec<2>& x, double time, double rho0) const {
  const Vec<2> a = phase(x);
  const double u = speed(time);
  return -0.25 * rho0 * u * u * (std::cos(2 * a[0]) + std::cos(2 * a[1]));
}

void TaylorGreen::addTo(std::vector<Figure>& row, const Observed<2>& state) const {
  const ParticleSet<2>& particles = state.particles;
  const auto position = particles[field::position];
  const std::size_t n = particles.nFluid();
  const double time = state.info.time, rho0 = state.info.materials.front().density;

  const auto velocities = orderedSum<RelativeDistance>(n, [&](std::size_t i) {
    const Vec<2> exact = velocity(position[i], time);
    return RelativeDistance{norm(particles[field::velocity][i] - exact), norm(exact)};
  });
  const auto measured = particles[field::pressure];
  const auto exact = [&](std::size_t i) { return pressure(position[i], time, rho0); };
  const auto count = static_cast<double>(n);
  const double mean = orderedSum<double>(n, [&](std::size_t i) { return measured[i]; }) / count;
  const double meanOfExact = orderedSum<double>(n, exact) / count;
  const auto pressures = orderedSum<RelativeDistance>(n, [&](std::size_t i) {
    const double reference = exact(i) - meanOfExact;
    return RelativeDistance{std::abs(measured[i] - mean - reference), std::abs(reference)};
  });
  row.push_back({"l1_velocity", "", velocities.value()});
  row.push_back({"l1_pressure", "", pressures.value()});
}

}  // namespace plenum
