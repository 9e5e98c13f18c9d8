// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"
#include "solver/phases.hpp"
#include "solver/step_record.hpp"

namespace plenum {

/// The longest step [s]: the fixed one of the case, or
/// cfl min(h/(c + |v|), sqrt(h/|a|)) over all fluid particles, at most h^2/(8 nu) (Morris et al.
/// 1997, doi 10.1006/jcph.1997.5776). h [m]. Of a gas cfl over the largest rate, gas.hpp.
double longestTimeStep(const SolverSettings& settings, const Phases& phases, double h,
                       const StepRecord& last);

/// Whether a step is so small that no run can end by it: a millionth of h/c and a thousandth of
/// h^2/nu; in a gas, whose speed of sound changes, a part of 1e10 of the end time.
bool isSenseless(double step, const SolverSettings& settings, const Phases& phases, double h);

}  // namespace plenum
