// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/interpolation.hpp"

namespace plenum {

/// Pressure and velocity at a fixed point, Shepard-normalised over the fluid particles near it:
/// sum V phi W / sum V W. Empty where the fluid takes less than a twentieth of the place.
template <int Dim>
class Probe {
 public:
  /// Throws InputError that names `key` for a point outside of `reach` and for an unknown material.
  Probe(const ProbeSettings& settings, const Observed<Dim>& start, const Box<Dim>& reach,
        const std::string& key);

  /// NAME_pressure [Pa m^(3-d)], NAME_velocity_x, ... [m/s].
  void addTo(std::vector<Figure>& row, const Interpolation<Dim>& fluid) const;

 private:
  std::string name_;
  FluidChoice choice_;
  Vec<Dim> point_;
};

extern template class Probe<1>;
extern template class Probe<2>;
extern template class Probe<3>;

}  // namespace plenum
