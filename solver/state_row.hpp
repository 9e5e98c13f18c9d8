// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/conserved.hpp"
#include "solver/figure.hpp"
#include "solver/measures/observers.hpp"

namespace plenum {

/// What measures see of a run as it is now.
template <int Dim>
Observed<Dim> observed(const Simulation<Dim>& simulation);

/// All measures of the present state, in the order of history.csv's columns: those that every run
/// has, then those that the case names. The same list makes the summary. `wallClock` [s] is the
/// time since the run began.
template <int Dim>
std::vector<Figure> measureState(const Simulation<Dim>& simulation, const Observers<Dim>& observers,
                                 double wallClock);

/// The same for measures that are not kept.
template <int Dim>
std::vector<Figure> measureState(const Simulation<Dim>& simulation,
                                 const MeasureSettings& measures = {});

}  // namespace plenum
