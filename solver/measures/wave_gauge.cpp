// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/measures/wave_gauge.hpp"

#include "particles/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace plenum {

template <int Dim>
WaveGauge<Dim>::WaveGauge(const GaugeSettings& settings, const Observed<Dim>& start,
                          const Box<Dim>& reach, const std::string& key)
    : name_(settings.name),
      choice_(settings.material, start.info, key + ".material"),
      vertical_(verticalOf(start.gravity, fmt::format("{} \"{}\"", key, settings.name))),
      dry_(settings.dry.value_or(std::numeric_limits<double>::quiet_NaN())) {
  std::size_t next = 0;
  for (int a = 0; a < Dim; ++a) {
    if (a == vertical_.axis) continue;
    place_[a] = settings.point[next++];
    if (place_[a] < reach.lower[a] || place_[a] > reach.upper[a])
      throw InputError(fmt::format(
          "{} \"{}\": {} = {:g} m lies outside of the scene, which reaches from {:g} to {:g} m; "
          "move it inside",
          key, name_, "xyz"[a], place_[a], reach.lower[a], reach.upper[a]));
  }
}

template <int Dim>
Vec<Dim> WaveGauge<Dim>::at(double height) const {
  Vec<Dim> x = place_;
  x[vertical_.axis] = vertical_.up * height;
  return x;
}

/// Heights of the fluid particles that the vertical can feel, from above.
template <int Dim>
std::vector<double> WaveGauge<Dim>::heights(const Interpolation<Dim>& fluid) const {
  const Observed<Dim>& state = fluid.state();
  std::vector<double> found;
  for (const Vec<Dim>& x : state.particles[field::position].first(state.particles.nFluid())) {
    Vec<Dim> across = state.info.domain.nearestImage(x - place_);
    across[vertical_.axis] = 0;
    if (normSquared(across) < fluid.support() * fluid.support())
      found.push_back(vertical_.up * x[vertical_.axis]);
  }
  std::ranges::sort(found, std::greater{});
  return found;
}

/// Along "up"; NaN if there is no fluid.
template <int Dim>
double WaveGauge<Dim>::height(const Interpolation<Dim>& fluid) const {
  // Steps much shorter than the kernel: between two of them the share of fluid has no crest.
  const double step = 0.25 * fluid.state().info.spacing, support = fluid.support();
  double outside = std::numeric_limits<double>::infinity();
  for (const double particle : heights(fluid)) {
    outside = std::min(outside, particle + support);  // nothing to feel between two far particles
    for (; outside > particle - support; outside -= step) {
      if (fluid.fluidFraction(at(outside - step), choice_) < 0.5) continue;
      double inside = outside - step;
      for (int bisection = 0; bisection < 30; ++bisection) {  // to 1e-9 of a step
        const double middle = 0.5 * (inside + outside);
        (fluid.fluidFraction(at(middle), choice_) < 0.5 ? outside : inside) = middle;
      }
      return 0.5 * (inside + outside);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

template <int Dim>
void WaveGauge<Dim>::addTo(std::vector<Figure>& row, const Interpolation<Dim>& fluid) const {
  const double found = height(fluid);
  row.push_back({name_, "m", std::isnan(found) ? dry_ : vertical_.up * found});
}

template class WaveGauge<1>;
template class WaveGauge<2>;
template class WaveGauge<3>;

}  // namespace plenum
