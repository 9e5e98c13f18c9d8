// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/measures.hpp"
#include "solver/conserved.hpp"
#include "solver/figure.hpp"

#include <vector>

namespace plenum {

/// All measures of the present state, in the order of history.csv's columns. The same list makes
/// the summary. `wallClock` [s] is the time since the run began.
template <int Dim>
std::vector<Figure> measureState(const Simulation<Dim>& simulation, bool freeSurface,
                                 double wallClock);

}  // namespace plenum
