// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/field.hpp"

#include <cmath>

namespace plenum {

/// Units in which pairs are computed, so that float holds the numbers of a galaxy as well as those
/// of a microchannel. Powers of two: scaling loses no digit.
struct Units {
  double length = 1;  ///< [m]
  double mass = 1;    ///< [kg]
  double time = 1;    ///< [s]

  /// Units in which these three lie in [1, 2).
  static Units near(double length, double mass, double speed) {
    const auto below = [](double x) { return std::exp2(std::floor(std::log2(x))); };
    Units units;
    units.length = below(length);
    units.mass = below(mass);
    units.time = units.length / below(speed);
    return units;
  }

  double speed() const { return length / time; }

  /// The unit of a field in `dim` dimensions, in SI.
  double of(FieldId id, int dim) const {
    const UnitPowers& p = infoOf(id).powers;
    return std::pow(mass, p.mass) * std::pow(length, p.length + p.lengthPerDimension * dim) *
           std::pow(time, p.time);
  }
};

/// A term whose parameters are in `units`. Terms with dimensional parameters have a member of this
/// name.
template <class Term>
Term inUnits(const Term& term, const Units& units) {
  if constexpr (requires { term.inUnits(units); })
    return term.inUnits(units);
  else
    return term;
}

}  // namespace plenum
