// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particle_set.hpp"

#include "particles/parallel.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <type_traits>

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
void ParticleSet<Dim>::permute(std::span<const std::uint32_t> order, std::span<std::byte> scratch) {
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
ParticleSet<Dim> ParticleSet<Dim>::fluidsOf(std::span<const std::uint32_t> indices) const {
  FieldSet fields;
  for (const FieldInfo& info : fieldTable)
    if (has(info.id) && info.scope != Scope::walls) fields |= {info.id};
  ParticleSet chosen(fields, indices.size(), 0);
  for (const FieldInfo& info : fieldTable) {
    if (!fields.has(info.id)) continue;
    std::visit(
        [&](auto& to) {
          const auto& from =
              std::get<std::remove_reference_t<decltype(to)>>(arrays_[index(info.id)]);
          for (std::size_t k = 0; k < indices.size(); ++k) to[k] = from[indices[k]];
        },
        chosen.arrays_[index(info.id)]);
  }
  return chosen;
}

namespace {

/// What `ParticleSet::exchangeFluids` says, of one array.
template <class Value>
void exchange(std::vector<Value>& values, std::size_t nFluid,
              std::span<const std::uint32_t> removed, std::span<const std::uint32_t> copied) {
  std::vector<Value> copies;
  copies.reserve(copied.size());
  for (const std::uint32_t i : copied) copies.push_back(values[i]);
  const auto at = [&](std::size_t i) { return values.begin() + static_cast<std::ptrdiff_t>(i); };
  auto end = removed.empty() ? at(nFluid) : at(removed.front());
  for (std::size_t k = 0; k < removed.size(); ++k) {
    const std::size_t next = k + 1 < removed.size() ? removed[k + 1] : nFluid;
    end = std::move(at(removed[k] + 1), at(next), end);
  }
  // Where particles left, copies take their places, as far as they go.
  const std::size_t nReplaced = std::min(removed.size(), copies.size());
  const auto rest = copies.begin() + static_cast<std::ptrdiff_t>(nReplaced);
  end = std::move(copies.begin(), rest, end);
  const auto walls = values.erase(end, at(nFluid));
  values.insert(walls, rest, copies.end());
}

}  // namespace

template <int Dim>
void ParticleSet<Dim>::exchangeFluids(std::span<const std::uint32_t> removed,
                                      std::span<const std::uint32_t> copied) {
  assert(std::ranges::is_sorted(removed));
  for (const FieldInfo& info : fieldTable)
    if (has(info.id) && info.scope != Scope::walls)
      std::visit([&](auto& values) { exchange(values, nFluid_, removed, copied); },
                 arrays_[index(info.id)]);
  nFluid_ += copied.size() - removed.size();
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
