// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/rigid_motion.hpp"
#include "particles/scene.hpp"

#include <algorithm>
#include <optional>

namespace plenum {

/// The motion of the container, if it has one: that of the walls, if all move as one.
template <int Dim>
const RigidMotion* containerMotion(const SceneInfo<Dim>& info) {
  if (info.walls.empty() || info.walls.front().motion.isStill()) return nullptr;
  const RigidMotion& first = info.walls.front().motion;
  const bool isCommon =
      std::ranges::all_of(info.walls, [&](const Wall& wall) { return wall.motion == first; });
  return isCommon ? &first : nullptr;
}

/// Where a point of the container at `before` [s] is at `after`.
template <int Dim>
auto containerMove(const SceneInfo<Dim>& info, double before, double after) {
  std::optional<Displacement> displacement;
  if (const RigidMotion* motion = containerMotion(info))
    displacement.emplace(*motion, before, after);
  return [displacement](const Vec<Dim>& x) { return displacement ? displacement->moved(x) : x; };
}

}  // namespace plenum
