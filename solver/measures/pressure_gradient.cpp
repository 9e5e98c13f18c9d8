// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/pressure_gradient.hpp"

#include "engine/ordered_sum.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

/// Sums for the straight line through points (z, p).
struct LineSums {
  double n = 0, z = 0, p = 0, zz = 0, zp = 0;
  LineSums& operator+=(const LineSums& b) {
    n += b.n;
    z += b.z;
    p += b.p;
    zz += b.zz;
    zp += b.zp;
    return *this;
  }
  double spread() const { return n * zz - z * z; }
  double slope() const { return (n * zp - z * p) / spread(); }
};

}  // namespace

template <int Dim>
PressureGradient<Dim>::PressureGradient(const PressureGradientSettings& settings,
                                        const Observed<Dim>& start, const std::string& key)
    : settings_(settings),
      choice_(settings.material, start.info, key + ".material"),
      vertical_(verticalOf(start.gravity, key)) {
  if (settings.material.empty() && start.info.materials.size() > 1)
    throw InputError(fmt::format("{}: the scene has {} fluids: choose one by {}.material = \"{}\"",
                                 key, start.info.materials.size(), key,
                                 start.info.materials.front().name));
  expected_ = -start.info.materials[choice_.row()].density * norm(start.gravity);
}

template <int Dim>
double PressureGradient<Dim>::error(const Observed<Dim>& state) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const ParticleSet<Dim>& particles = state.particles;
  const auto position = particles[field::position];
  const auto pressure = particles[field::pressure];
  const auto heightOf = [&](std::size_t i) { return position[i][vertical_.axis]; };
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = 0; i < particles.nFluid(); ++i)
    if (choice_.has(particles, i)) {
      lowest = std::min(lowest, vertical_.up * heightOf(i));
      highest = std::max(highest, vertical_.up * heightOf(i));
    }
  if (!(highest > lowest)) return none;
  const double half = 0.5 * state.info.spacing;
  const double bottom = settings_.bottom ? vertical_.up * *settings_.bottom : lowest - half;
  const double surface = settings_.surface ? vertical_.up * *settings_.surface : highest + half;
  const double middle = 0.5 * (bottom + surface);
  const double reach = 0.5 * settings_.middle * std::abs(surface - bottom);
  const auto sums = orderedSum<LineSums>(particles.nFluid(), [&](std::size_t i) {
    const double z = vertical_.up * heightOf(i) - middle;
    if (!choice_.has(particles, i) || std::abs(z) > reach) return LineSums{};
    const double p =
        pressure[i] - expected_ * z;  // what the expected line leaves: no digits are lost
    return LineSums{1, z, p, z * z, z * p};
  });
  if (!(sums.spread() > 0)) return none;
  return 100 * sums.slope() / expected_;
}

template <int Dim>
void PressureGradient<Dim>::addTo(std::vector<Figure>& row, const Observed<Dim>& state) const {
  row.push_back({"pressure_gradient_error", "%", error(state)});
}

template class PressureGradient<1>;
template class PressureGradient<2>;
template class PressureGradient<3>;

}  // namespace plenum
