// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particle_set.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace plenum {

template <int Dim>
ParticleSet<Dim>::ParticleSet(FieldSet fields, std::size_t nFluid, std::size_t nWalls)
    : nFluid_(nFluid), nWalls_(nWalls) {
  add(fields);
}

template <int Dim>
std::size_t ParticleSet<Dim>::sizeOf(FieldId id) const {
  switch (infoOf(id).scope) {
    case Scope::fluid:
      return nFluid_;
    case Scope::walls:
      return nWalls_;
    case Scope::all:
      break;
  }
  return size();
}

template <int Dim>
void ParticleSet<Dim>::add(FieldSet fields) {
  for (const FieldInfo& info : fieldTable) {
    if (!fields.has(info.id) || has(info.id)) continue;
    Array& array = arrays_[index(info.id)];
    const std::size_t n = sizeOf(info.id);
    switch (info.rank) {
      case Rank::scalar:
        array = std::vector<double>(n);
        break;
      case Rank::vector:
        array = std::vector<Vec<Dim>>(n);
        break;
      case Rank::label:
        array = std::vector<std::int32_t>(n);
        break;
      case Rank::id:
        array = std::vector<std::uint64_t>(n);
        break;
    }
  }
  fields_ |= fields;
}

template <int Dim>
void ParticleSet<Dim>::remove(FieldSet fields) {
  for (const FieldInfo& info : fieldTable)
    if (fields.has(info.id)) arrays_[index(info.id)] = Array{};
  fields_ = fields_.without(fields);
}

template <int Dim>
void ParticleSet<Dim>::permute(std::span<const std::uint32_t> order,
                               std::span<std::byte> scratch) {
  assert(order.size() == size());
  assert(scratch.size() >= size() * permuteBytes);
  forEachField([&](const FieldInfo& info, auto values) {
    using Value = typename decltype(values)::value_type;
    const std::size_t first = info.scope == Scope::walls ? nFluid_ : 0;
    auto* sorted = reinterpret_cast<Value*>(scratch.data());
    forEachIndex(values.size(),
                 [&](std::size_t k) { sorted[k] = values[order[first + k] - first]; });
    if (!values.empty()) std::memcpy(values.data(), sorted, values.size_bytes());
  });
}

template <int Dim>
double ParticleSet<Dim>::bytesPerParticle() const {
  if (size() == 0) return 0;
  std::size_t bytes = 0;
  forEachField([&](const FieldInfo&, auto values) { bytes += values.size_bytes(); });
  return static_cast<double>(bytes) / static_cast<double>(size());
}

template class ParticleSet<1>;
template class ParticleSet<2>;
template class ParticleSet<3>;

}  // namespace plenum
