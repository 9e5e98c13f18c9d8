// SPDX-License-Identifier: GPL-3.0-or-later
//
// /Plenum of a particle file: everything about a scene but its particles. Only particles/*.cpp
// include this.
#pragma once

#include "particles/hdf5.hpp"
#include "particles/scene.hpp"

#include <cstdint>

namespace plenum {

/// Version of the layout of /Plenum; a reader takes no other.
inline constexpr std::int32_t particleFileSchema = 1;

/// kernel support / smoothing length.
inline constexpr double supportOverH = 2;

template <int Dim>
void writeSceneInfo(const hdf5::Group& plenum, const SceneInfo<Dim>& info);

/// Throws InputError for anything that is missing, of the wrong length or senseless.
template <int Dim>
SceneInfo<Dim> readSceneInfo(const hdf5::Group& plenum);

}  // namespace plenum
