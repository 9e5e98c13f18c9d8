// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/tile_work.hpp"
#include "particles/field.hpp"

#include <memory>

namespace plenum {

/// Groups of particles: who receives a sum, and from whom.
enum class Group { fluids, walls, all };

constexpr bool hasFluids(Group g) { return g != Group::walls; }
constexpr bool hasWalls(Group g) { return g != Group::fluids; }

/// A pass whose kernel and terms were chosen at run time: what an engine runs.
template <int Dim>
struct PairPass {
  FieldSet reads, writes;
  Group receivers = Group::fluids, sources = Group::all;
  bool reactions = false;  ///< walls get what they do to fluids, too, and nothing from each other
  TileFunction<Dim, float> inFloat = nullptr;
  TileFunction<Dim, double> inDouble = nullptr;
  std::shared_ptr<const void> parameters;  ///< what the functions were made for

  explicit operator bool() const { return inDouble != nullptr; }
};

}  // namespace plenum
