// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/box_volume.hpp"

#include "engine/ordered_sum.hpp"

#include <algorithm>

namespace plenum {

template <int Dim>
BoxVolume<Dim>::BoxVolume(const VolumeSettings& settings, const Observed<Dim>& start,
                          const std::string& key)
    : name_(settings.name), choice_(settings.material, start.info, key + ".material") {
  std::copy_n(settings.lower.begin(), Dim, box_.lower.components.begin());
  std::copy_n(settings.upper.begin(), Dim, box_.upper.components.begin());
}

template <int Dim>
void BoxVolume<Dim>::addTo(std::vector<Figure>& row, const Observed<Dim>& state) const {
  const ParticleSet<Dim>& particles = state.particles;
  const auto position = particles[field::position];
  const auto mass = particles[field::mass];
  const auto density = particles[field::density];
  const double volume = orderedSum<double>(particles.nFluid(), [&](std::size_t i) {
    return choice_.has(particles, i) && box_.contains(position[i]) ? mass[i] / density[i] : 0.0;
  });
  row.push_back({name_, volumeUnit(Dim), volume});
}

template class BoxVolume<1>;
template class BoxVolume<2>;
template class BoxVolume<3>;

}  // namespace plenum
