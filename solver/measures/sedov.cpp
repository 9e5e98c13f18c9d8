// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/sedov.hpp"

#include "engine/ordered_sum.hpp"
#include "particles/errors.hpp"
#include "solver/measures/gas.hpp"

#include <algorithm>
#include <cmath>

namespace plenum {

namespace {

SedovBlast blastOf(int dim, const SolverSettings& solver, const std::string& key) {
  requireIdealGas(solver, key);
  try {
    return SedovBlast(dim, solver.adiabaticIndex);
  } catch (const InputError& error) {
    throw InputError(key + ": solver.adiabatic_index, " + error.what());
  }
}

}  // namespace

template <int Dim>
Sedov<Dim>::Sedov(const SedovSettings& settings, const Observed<Dim>& start, const std::string& key)
    : settings_(settings),
      center_(vectorOf<Dim>(settings.center)),
      gamma_(start.settings.adiabaticIndex),
      exact_(blastOf(Dim, start.settings, key)) {}

template <int Dim>
double Sedov<Dim>::shockRadius(double time) const {
  return exact_.shockRadius(time, settings_.energy, settings_.density);
}

template <int Dim>
double Sedov<Dim>::density(double radius, double time) const {
  const double R = shockRadius(time);
  return settings_.density * (radius < R ? exact_.at(radius / R).density : 1);
}

template <int Dim>
double Sedov<Dim>::radiusOf(const Observed<Dim>& state, std::size_t i) const {
  return norm(state.info.domain.nearestImage(state.particles[field::position][i] - center_));
}

template <int Dim>
typename Sedov<Dim>::Peak Sedov<Dim>::peak(const Observed<Dim>& state) const {
  const ParticleSet<Dim>& particles = state.particles;
  const double width = state.info.spacing;
  std::vector<VolumeMean> shells;
  for (std::size_t i = 0; i < particles.nFluid(); ++i) {
    const auto shell = static_cast<std::size_t>(radiusOf(state, i) / width);
    if (shell >= shells.size()) shells.resize(shell + 1);
    const double m = particles[field::mass][i];
    shells[shell] += {m, m / particles[field::density][i]};
  }
  Peak best{std::numeric_limits<double>::quiet_NaN(), 0};
  for (std::size_t k = 0; k < shells.size(); ++k) {
    const double mean = shells[k].value();
    if (mean > best.density) best = {(static_cast<double>(k) + 0.5) * width, mean};
  }
  return best;
}

template <int Dim>
void Sedov<Dim>::addTo(std::vector<Figure>& row, const Observed<Dim>& state) const {
  const ParticleSet<Dim>& particles = state.particles;
  const double time = state.info.time, reach = 1.2 * shockRadius(time);
  const auto error = orderedSum<VolumeMean>(particles.nFluid(), [&](std::size_t i) -> VolumeMean {
    const double r = radiusOf(state, i);
    if (!(r < reach)) return {};
    const double rho = particles[field::density][i], V = particles[field::mass][i] / rho;
    return {V * std::abs(rho - density(r, time)), V};
  });
  const Peak largest = peak(state);
  row.push_back({"l1_density", "", error.value() / settings_.density});
  row.push_back({"shock_radius", "m", largest.radius});
  row.push_back(
      {"peak_density", "", largest.density * (gamma_ - 1) / ((gamma_ + 1) * settings_.density)});
}

template class Sedov<1>;
template class Sedov<2>;
template class Sedov<3>;

}  // namespace plenum
