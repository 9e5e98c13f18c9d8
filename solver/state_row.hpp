// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/measures.hpp"
#include "solver/conserved.hpp"

#include <string>
#include <vector>

namespace plenum {

/// One named figure of a state.
struct Figure {
  std::string name;
  std::string unit;
  double value = 0;
};

/// All measures of the present state, in the order of history.csv's columns. The same list makes
/// the summary. `wallClock` [s] is the time since the run began.
template <int Dim>
std::vector<Figure> measureState(const Simulation<Dim>& simulation, bool freeSurface,
                                 double wallClock);

/// The value of a named figure. Throws std::out_of_range if there is none.
double valueOf(const std::vector<Figure>& figures, const std::string& name);

}  // namespace plenum
