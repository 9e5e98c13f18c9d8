// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/field.hpp"

#include <array>

namespace plenum {

/// A field that no particle stores: numerator / density^power, computed in double when particles
/// are loaded for a pass. Particles that have them add `addend` to the numerator, and take
/// field::omegaDensity for the second density.
struct DerivedField {
  FieldId id;
  FieldSet numerator;  ///< one field, or none for 1
  int power;
  FieldSet addend = {};  ///< one field, or none for 0
};

inline constexpr std::array derivedTable{
    DerivedField{FieldId::volume, {FieldId::mass}, 1},
    DerivedField{FieldId::specificVolume, {}, 1},
    DerivedField{
        FieldId::pressureOverDensitySquared, {FieldId::pressure}, 2, {FieldId::viscousPressure}},
};

/// The fields that particles must store so that `fields` can be loaded.
constexpr FieldSet storedFor(FieldSet fields) {
  for (const DerivedField& derived : derivedTable)
    if (fields.has(derived.id))
      fields = fields.without({derived.id}) | derived.numerator | FieldSet{FieldId::density};
  return fields;
}

}  // namespace plenum
