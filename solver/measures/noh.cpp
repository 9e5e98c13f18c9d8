// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/noh.hpp"

#include "engine/ordered_sum.hpp"
#include "solver/measures/gas.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

template <int Dim>
Noh<Dim>::Noh(const NohSettings& settings, const Observed<Dim>& start, const std::string& key)
    : settings_(settings),
      center_(vectorOf<Dim>(settings.center)),
      gamma_(start.settings.adiabaticIndex) {
  requireIdealGas(start.settings, key);
}

template <int Dim>
double Noh<Dim>::shockRadius(double time) const {
  return 0.5 * (gamma_ - 1) * settings_.speed * time;
}

template <int Dim>
double Noh<Dim>::densityBehind() const {
  return settings_.density * std::pow((gamma_ + 1) / (gamma_ - 1), Dim);
}

template <int Dim>
double Noh<Dim>::density(double radius, double time) const {
  if (radius < shockRadius(time)) return densityBehind();
  if (Dim == 1 || time == 0) return settings_.density;
  return settings_.density * std::pow(1 + settings_.speed * time / radius, Dim - 1);
}

template <int Dim>
double Noh<Dim>::countedRadius(double time) const {
  if (settings_.within) return *settings_.within;
  double radius = 2 * shockRadius(time);
  if (settings_.radius) {
    // Nothing presses on the edge, so what began inside of it has moved in freely.
    const double edge = *settings_.radius - settings_.speed * time;
    radius = std::min(radius, std::max(0.0, edge));
  }
  return radius;
}

template <int Dim>
void Noh<Dim>::addTo(std::vector<Figure>& row, const Observed<Dim>& state) const {
  const ParticleSet<Dim>& particles = state.particles;
  const double time = state.info.time;
  const auto position = particles[field::position];
  const auto mass = particles[field::mass], density = particles[field::density];
  const auto meanWithin = [&](double radius, const auto& quantity) {
    return orderedSum<VolumeMean>(particles.nFluid(),
                                  [&](std::size_t i) -> VolumeMean {
                                    const double r =
                                        norm(state.info.domain.nearestImage(position[i] - center_));
                                    if (!(r < radius)) return {};
                                    const double V = mass[i] / density[i];
                                    return {V * quantity(i, r), V};
                                  })
        .value();
  };
  const double error = meanWithin(countedRadius(time), [&](std::size_t i, double r) {
    return std::abs(density[i] - this->density(r, time));
  });
  const double behind =
      meanWithin(0.8 * shockRadius(time), [&](std::size_t i, double) { return density[i]; });
  row.push_back({"l1_density", "", error / densityBehind()});
  row.push_back({"density_behind_shock", "", behind / densityBehind()});
}

template class Noh<1>;
template class Noh<2>;
template class Noh<3>;

}  // namespace plenum
