// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/interpolation.hpp"

namespace plenum {

/// Height of the surface above a horizontal place: the highest point of the vertical at which the
/// share of fluid (Interpolation::fluidFraction) falls through 0.5.
template <int Dim>
class WaveGauge {
 public:
  /// Throws InputError that names `key` for a place outside of `reach`, for an unknown material and
  /// without gravity.
  WaveGauge(const GaugeSettings& settings, const Observed<Dim>& start, const Box<Dim>& reach,
            const std::string& key);

  /// NAME [m]: the coordinate along the axis of gravity.
  void addTo(std::vector<Figure>& row, const Interpolation<Dim>& fluid) const;

 private:
  std::vector<double> heights(const Interpolation<Dim>& fluid) const;
  double height(const Interpolation<Dim>& fluid) const;
  Vec<Dim> at(double height) const;  // height: along "up"

  std::string name_;
  FluidChoice choice_;
  Vertical vertical_;
  Vec<Dim> place_;  // horizontal components
  double dry_;      // NaN: nothing
};

extern template class WaveGauge<1>;
extern template class WaveGauge<2>;
extern template class WaveGauge<3>;

}  // namespace plenum
