// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/cloud.hpp"

#include "engine/ordered_sum.hpp"
#include "solver/measures/gas.hpp"

#include <cmath>

namespace plenum {

template <int Dim>
Cloud<Dim>::Cloud(const CloudSettings& settings, const Observed<Dim>& start, const std::string& key)
    : settings_(settings) {
  requireIdealGas(start.settings, key);
}

template <int Dim>
double Cloud<Dim>::kelvinHelmholtzTime() const {
  const double contrast = settings_.density / settings_.windDensity;
  return 1.6 * 2 * settings_.radius * std::sqrt(contrast) / settings_.windSpeed;
}

template <int Dim>
double Cloud<Dim>::mass() const {
  return settings_.density * unitSphereSurface(Dim) / Dim * std::pow(settings_.radius, Dim);
}

template <int Dim>
void Cloud<Dim>::addTo(std::vector<Figure>& row, const Observed<Dim>& state) const {
  const ParticleSet<Dim>& particles = state.particles;
  const auto density = particles[field::density], energy = particles[field::internalEnergy];
  const double least = 0.64 * settings_.density, hottest = 0.9 * settings_.windInternalEnergy;
  const double left = orderedSum<double>(particles.nFluid(), [&](std::size_t i) {
    return density[i] > least && energy[i] < hottest ? particles[field::mass][i] : 0.0;
  });
  row.push_back({"cloud_mass", "", left / mass()});
  row.push_back({"time_over_tau_kh", "", state.info.time / kelvinHelmholtzTime()});
}

template class Cloud<1>;
template class Cloud<2>;
template class Cloud<3>;

}  // namespace plenum
