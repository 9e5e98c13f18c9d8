// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/field.hpp"

namespace plenum {

/// Numbers that a field takes a particle in `Dim` dimensions.
template <int Dim>
constexpr int componentsOf(FieldId id) {
  return infoOf(id).rank == Rank::vector ? Dim : 1;
}

/// Numbers of all fields of a set, one after the other in the order of the field table.
template <int Dim>
constexpr int componentsOf(FieldSet fields) {
  int n = 0;
  for (const FieldInfo& info : fieldTable)
    if (fields.has(info.id)) n += componentsOf<Dim>(info.id);
  return n;
}

/// Those before a field.
template <int Dim>
constexpr int offsetOf(FieldSet fields, FieldId id) {
  int n = 0;
  for (const FieldInfo& info : fieldTable) {
    if (info.id == id) break;
    if (fields.has(info.id)) n += componentsOf<Dim>(info.id);
  }
  return n;
}

}  // namespace plenum
