// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace plenum {

/// Tait's equation of state in MacDonald's form, [C] (2.4):
/// p = p0 + rho0 c^2/gamma ((rho/rho0)^gamma - 1)   [Pa m^(3-d)],
/// and not below the pressure at which the fluid cavitates.
struct Tait {
  double referenceDensity = 1;                                           ///< rho0 [kg/m^d]
  double soundSpeed = 10;                                                ///< c [m/s]
  double backgroundPressure = 0;                                         ///< p0 [Pa m^(3-d)]
  double exponent = 1;                                                   ///< gamma
  double cavitationPressure = -std::numeric_limits<double>::infinity();  ///< [Pa m^(3-d)]

  double pressure(double density) const { return std::max(elastic(density), cavitationPressure); }

  /// The density at which the pressure is p without cavitation   [kg/m^d]; NaN if there is none.
  double density(double p) const {
    const double stiffness = soundSpeed * soundSpeed * referenceDensity / exponent;
    const double ratio = 1 + (p - backgroundPressure) / stiffness;
    if (!(ratio > 0)) return std::numeric_limits<double>::quiet_NaN();
    return referenceDensity * (exponent == 1 ? ratio : std::pow(ratio, 1 / exponent));
  }

  /// Specific energy of compression from rho0, the integral of p/rho^2 d rho   [J/kg].
  double compressionEnergy(double density) const {
    if (!(elastic(density) < cavitationPressure)) return elasticEnergy(density);
    const double least = this->density(cavitationPressure);
    return elasticEnergy(least) + cavitationPressure * (1 / least - 1 / density);
  }

 private:
  double elastic(double density) const {
    const double stiffness = soundSpeed * soundSpeed * referenceDensity / exponent;
    const double ratio = density / referenceDensity;
    if (exponent == 1) return backgroundPressure + stiffness * (ratio - 1);
    return backgroundPressure +
           stiffness * ((exponent == 7 ? seventhPower(ratio) : std::pow(ratio, exponent)) - 1);
  }

  double elasticEnergy(double density) const {
    const double ratio = density / referenceDensity;
    const double c2 = soundSpeed * soundSpeed;
    const double atReference = backgroundPressure - referenceDensity * c2 / exponent;
    const double constantPart = atReference / referenceDensity * (1 - 1 / ratio);
    if (exponent == 1) return constantPart + c2 * std::log(ratio);
    return constantPart + c2 / (exponent * (exponent - 1)) * (std::pow(ratio, exponent - 1) - 1);
  }

  /// Water's exponent, a tenth of what std::pow costs.
  static double seventhPower(double x) {
    const double cube = x * x * x;
    return cube * cube * x;
  }
};

/// One equation of state a material. `materials` may be empty: all particles are of the first.
class MaterialTable {
 public:
  explicit MaterialTable(std::vector<Tait> rows) : rows_(std::move(rows)) {}

  const Tait& of(std::span<const std::int32_t> materials, std::size_t particle) const {
    return rows_[materials.empty() ? 0 : static_cast<std::size_t>(materials[particle])];
  }

  /// pressures[i] from densities[i]; all of the same length.
  void pressures(std::span<const double> densities, std::span<const std::int32_t> materials,
                 std::span<double> pressures) const;

 private:
  std::vector<Tait> rows_;
};

}  // namespace plenum
