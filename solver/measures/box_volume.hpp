// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/measure_settings.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observed.hpp"

namespace plenum {

/// Volume of the fluid inside a box: sum of m/rho of the particles whose place is in it. Along
/// periodic axes the place is that within the domain.
template <int Dim>
class BoxVolume {
 public:
  /// Throws InputError that names `key` for an unknown material.
  BoxVolume(const VolumeSettings& settings, const Observed<Dim>& start, const std::string& key);

  /// NAME [m^d].
  void addTo(std::vector<Figure>& row, const Observed<Dim>& state) const;

 private:
  std::string name_;
  Box<Dim> box_;
  FluidChoice choice_;
};

extern template class BoxVolume<1>;
extern template class BoxVolume<2>;
extern template class BoxVolume<3>;

}  // namespace plenum
