// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/instruction_set.hpp"
#include "engine/pair_loop.hpp"
#include "engine/pair_pass.hpp"

#include <algorithm>

namespace plenum {

/// A pass for an engine from one whose type is known, compiled where it is written (and not for the
/// best processor at hand, as those of solver/pair_loops.cpp are). `bytes` is the size of a pack,
/// `units` are those of the engine.
template <int Dim, int bytes = isa::Baseline::bytes, class Profile, class... Terms>
PairPass<Dim> passOf(const Pass<Profile, Terms...>& pass, Group receivers = Group::fluids,
                     Group sources = Group::all, const Units& units = {}) {
  constexpr int most = clusterSize;
  using Single = Pack<float, std::min<int>(bytes / sizeof(float), most), isa::Baseline>;
  using Double = Pack<double, std::min<int>(bytes / sizeof(double), most), isa::Baseline>;
  PairPass<Dim> made;
  made.reads = pass.reads;
  made.writes = pass.writes;
  made.receivers = receivers;
  made.sources = sources;
  made.inFloat = &sumTiles<Single, Dim, Profile, Terms...>;
  made.inDouble = &sumTiles<Double, Dim, Profile, Terms...>;
  made.parameters = std::make_shared<const Pass<Profile, Terms...>>(pass.inUnits(units));
  return made;
}

}  // namespace plenum
