// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/field.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

namespace plenum {

/// Particles as one array a field: fluid particles first, walls as the tail.
/// Only the fields that somebody asked for exist.
template <int Dim>
class ParticleSet {
 public:
  ParticleSet() = default;
  ParticleSet(FieldSet fields, std::size_t nFluid, std::size_t nWalls);

  std::size_t size() const { return nFluid_ + nWalls_; }
  std::size_t nFluid() const { return nFluid_; }
  std::size_t nWalls() const { return nWalls_; }

  /// Number of entries of a field's array (its scope decides).
  std::size_t sizeOf(FieldId id) const;

  FieldSet fields() const { return fields_; }
  bool has(FieldId id) const { return fields_.has(id); }

  /// Allocates the fields that are missing; their values are zero.
  void add(FieldSet fields);
  void remove(FieldSet fields);

  /// The array of a field that this set has; walls' fields start at the first wall.
  template <Rank R>
  std::span<ValueOf<R, Dim>> operator[](Field<R> field) {
    return std::get<std::vector<ValueOf<R, Dim>>>(arrays_[index(field.id)]);
  }
  template <Rank R>
  std::span<const ValueOf<R, Dim>> operator[](Field<R> field) const {
    return std::get<std::vector<ValueOf<R, Dim>>>(arrays_[index(field.id)]);
  }

  /// Calls `visit(info, span)` for every field of this set, in the order of the field table.
  template <class Visit>
  void forEachField(Visit&& visit) const {
    for (const FieldInfo& info : fieldTable)
      if (has(info.id))
        std::visit([&](const auto& values) { visit(info, std::span(values)); },
                   arrays_[index(info.id)]);
  }
  template <class Visit>
  void forEachField(Visit&& visit) {
    for (const FieldInfo& info : fieldTable)
      if (has(info.id))
        std::visit([&](auto& values) { visit(info, std::span(values)); }, arrays_[index(info.id)]);
  }

  /// New order within the fluid and within the walls: `order[k]` is the old index of the particle
  /// that becomes number k. length size(); fluids stay before walls. `scratch` has room for
  /// permuteBytes a particle and is aligned as its values are.
  void permute(std::span<const std::uint32_t> order, std::span<std::byte> scratch);
  static constexpr std::size_t permuteBytes = std::max(sizeof(Vec<Dim>), sizeof(std::uint64_t));

  /// A set of the fluid particles with these indices alone, with all fields but those of walls.
  ParticleSet fluidsOf(std::span<const std::uint32_t> indices) const;

  /// The fluid particles `removed` (in rising order) leave, and copies of those in `copied` come
  /// behind the fluids that stay, ids and all. Indices are those from before; the others keep their
  /// order, and so do walls.
  void exchangeFluids(std::span<const std::uint32_t> removed,
                      std::span<const std::uint32_t> copied);

  /// Bytes of all arrays per particle.
  double bytesPerParticle() const;

 private:
  using Array = std::variant<std::vector<double>, std::vector<Vec<Dim>>, std::vector<std::int32_t>,
                             std::vector<std::uint64_t>>;

  static std::size_t index(FieldId id) { return static_cast<std::size_t>(id); }

  FieldSet fields_;
  std::size_t nFluid_ = 0;
  std::size_t nWalls_ = 0;
  std::array<Array, nFields> arrays_;
};

extern template class ParticleSet<1>;
extern template class ParticleSet<2>;
extern template class ParticleSet<3>;

}  // namespace plenum
