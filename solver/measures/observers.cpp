// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/observers.hpp"

#include "engine/measures.hpp"
#include "engine/voids.hpp"

#include <fmt/format.h>

namespace plenum {

namespace {

std::string keyOf(const char* list, std::size_t k) {
  return fmt::format("measures.{}[{}]", list, k);
}

}  // namespace

template <int Dim>
Observers<Dim>::Observers(const MeasureSettings& settings, const Observed<Dim>& start)
    : settings_(settings) {
  const Box<Dim> reach = reachOf(start);
  for (std::size_t k = 0; k < settings.probes.size(); ++k)
    probes_.emplace_back(settings.probes[k], start, reach, keyOf("probe", k));
  for (std::size_t k = 0; k < settings.gauges.size(); ++k)
    gauges_.emplace_back(settings.gauges[k], start, reach, keyOf("gauge", k));
  if (settings.front) front_.emplace(*settings.front, start, "measures.front");
  for (std::size_t k = 0; k < settings.volumes.size(); ++k)
    volumes_.emplace_back(settings.volumes[k], start, keyOf("volume", k));
  if (settings.pressureGradient)
    pressureGradient_.emplace(*settings.pressureGradient, start, "measures.pressure_gradient");
  if (settings.taylorGreen) taylorGreen_.emplace(*settings.taylorGreen);
  if (settings.couette) couette_.emplace(*settings.couette);
  addGasMeasures(settings, start);
}

template <int Dim>
void Observers<Dim>::addGasMeasures(const MeasureSettings& settings, const Observed<Dim>& start) {
  if (settings.riemann) riemann_.emplace(*settings.riemann, start, "measures.riemann");
  if (settings.noh) noh_.emplace(*settings.noh, start, "measures.noh");
  if (settings.sedov) sedov_.emplace(*settings.sedov, start, "measures.sedov");
  if constexpr (Dim > 1)
    if (settings.gresho) gresho_.emplace(*settings.gresho, start, "measures.gresho");
  if (settings.cloud) cloud_.emplace(*settings.cloud, start, "measures.cloud");
}

template <int Dim>
void Observers<Dim>::addGases(std::vector<Figure>& row, const Observed<Dim>& state) const {
  if (riemann_) riemann_->addTo(row, state);
  if (noh_) noh_->addTo(row, state);
  if (sedov_) sedov_->addTo(row, state);
  if constexpr (Dim > 1)
    if (gresho_) gresho_->addTo(row, state);
  if (cloud_) cloud_->addTo(row, state);
}

template <int Dim>
void Observers<Dim>::addOrder(std::vector<Figure>& row, const Observed<Dim>& state) const {
  const SceneInfo<Dim>& info = state.info;
  const SpacingMeasures s = measureSpacing(state.particles, info.domain, info.spacing);
  row.push_back({"nn_min", "d_ref", s.minNearest});
  row.push_back({"nn_mean", "d_ref", s.meanNearest});
  row.push_back({"f.1", "", s.below01});
  row.push_back({"f.5", "", s.below05});
  row.push_back({"f.85", "", s.below085});
  if (Dim == 2) row.push_back({"psi6", "", s.psi6});
  row.push_back({"void1", "", measureVoids(state.particles, info, settings_.freeSurface)});
  row.push_back({"left", "", static_cast<double>(countLeft(state.particles, info))});
  row.push_back({"escaped", "", static_cast<double>(countEscaped(state.particles, info))});
}

template <int Dim>
void Observers<Dim>::addTo(std::vector<Figure>& row, const Observed<Dim>& state) const {
  if (settings_.order) addOrder(row, state);
  if (!probes_.empty() || !gauges_.empty()) {
    const Interpolation<Dim> fluid(state);
    for (const Probe<Dim>& probe : probes_) probe.addTo(row, fluid);
    for (const WaveGauge<Dim>& gauge : gauges_) gauge.addTo(row, fluid);
  }
  if (front_) front_->addTo(row, state);
  for (const BoxVolume<Dim>& volume : volumes_) volume.addTo(row, state);
  if (pressureGradient_) pressureGradient_->addTo(row, state);
  if constexpr (Dim == 2) {
    if (taylorGreen_) taylorGreen_->addTo(row, state);
    if (couette_) couette_->addTo(row, state);
  }
  addGases(row, state);
}

template class Observers<1>;
template class Observers<2>;
template class Observers<3>;

}  // namespace plenum
