// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/case_settings.hpp"

namespace plenum {

/// What a summed density has too much because the particle itself stands at the middle of its
/// kernel, epsilon (N/100)^-alpha W(0), in m h^-d; 0 if the settings ask for no correction. N is
/// the number of neighbours in the support. Dehnen & Aly 2012, doi 10.1111/j.1365-2966.2012.21439.x
/// (18), (19) and table 1.
double selfTermCorrection(const SolverSettings& settings, int dimension);

/// Whether it is known for this kernel and dimension.
bool hasSelfTermCorrection(const std::string& kernel, int dimension);

}  // namespace plenum
