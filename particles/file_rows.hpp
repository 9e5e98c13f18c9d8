// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fields as files hold them: one row a particle, vectors with three components, and a fill value
// for particles that do not carry the field (0; -1 for labels).
#pragma once

#include "particles/particle_set.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace plenum {

/// Rows of one field: refers to the particle set where that needs no change, else owns a copy.
template <class T>
struct FileRows {
  std::vector<T> owned;
  std::span<const T> values;  ///< length size() * components
  int components = 1;
};

/// The element type in files of a value of the particle set.
template <class Value>
using FileNumber = std::conditional_t<std::is_arithmetic_v<Value>, Value, double>;

/// `values` is the span of the field `info` in `particles`, as `forEachField` gives it.
template <int Dim, class Value>
FileRows<FileNumber<std::remove_const_t<Value>>> rowsOf(const ParticleSet<Dim>& particles,
                                                        const FieldInfo& info,
                                                        std::span<Value> values) {
  using Number = FileNumber<std::remove_const_t<Value>>;
  constexpr bool isVector = !std::is_arithmetic_v<std::remove_const_t<Value>>;
  FileRows<Number> rows;
  rows.components = isVector ? 3 : 1;
  if constexpr (!isVector || Dim == 3) {
    if (info.scope == Scope::all) {
      if constexpr (isVector)
        rows.values = {values.empty() ? nullptr : values[0].components.data(), 3 * values.size()};
      else
        rows.values = values;
      return rows;
    }
  }
  const auto width = static_cast<std::size_t>(rows.components);
  const auto fill = static_cast<Number>(info.rank == Rank::label ? -1 : 0);
  rows.owned.assign(particles.size() * width, fill);
  const std::size_t first = info.scope == Scope::walls ? particles.nFluid() : 0;
  const auto n = static_cast<std::ptrdiff_t>(values.size());
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    Number* row = rows.owned.data() + (first + i) * width;
    if constexpr (isVector)
      std::copy_n(values[i].components.data(), Dim, row);
    else
      *row = values[i];
  }
  rows.values = rows.owned;
  return rows;
}

/// 0 for fluid, 1 for wall particles.
template <int Dim>
std::vector<std::uint8_t> particleTypes(const ParticleSet<Dim>& particles) {
  std::vector<std::uint8_t> types(particles.size(), 0);
  std::fill(types.begin() + static_cast<std::ptrdiff_t>(particles.nFluid()), types.end(),
            std::uint8_t{1});
  return types;
}

}  // namespace plenum
